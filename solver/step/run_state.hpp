#pragma once
#include "solver/particles/state.hpp"
#include "solver/sensors/sensors.hpp"
#include "solver/statistics.hpp"

namespace seiche::solver {

/// All that the next step of a run depends on, its parameters apart. A copy, given to a new simulation of the same
/// parameters, goes on with the same bytes.
template <int D>
struct RunState {
  State<D> particles;
  SensorMemory sensors = {};
  Statistics totals = {};
  long fluid_at_start = 0;  ///< particles
  double fastest = 0;       ///< greatest speed of the fluid [m/s]; the next step's length follows from it
  int short_steps = 0;      ///< how many in a row were far below their cap, by Watch::check_step
};

}  // namespace seiche::solver
