#pragma once
#include <memory>
#include <vector>

#include "solver/column.hpp"
#include "solver/sensors/budget.hpp"
#include "solver/sensors/fluid_cells.hpp"
#include "solver/sensors/surface_profile.hpp"

namespace seiche::solver {

/// The liquid at one instant, with what sensors share.
template <int D>
struct Instant {
  const State<D>& s;
  const FluidCells<D>& cells;
  const SurfaceProfile<D>& surface;
  const Budget<D>& budget;
};

/// All sensors of one kind.
template <int D>
class Sensor {
 public:
  virtual ~Sensor() = default;

  /// Appends a value for each column of its kind.
  virtual void read(const Instant<D>& now, Scalars& values) = 0;
};

/// What sensors are made for.
template <int D>
struct SensorSite {
  const Parameters& p;
  const Shape<D>& tank;
  const State<D>& start;  ///< at t = 0
};

/// A row of the table of kinds.
template <int D>
struct SensorKind {
  /// None: no such sensor is asked for.
  std::vector<Column> (*columns)(const Parameters& p);
  std::unique_ptr<Sensor<D>> (*make)(const SensorSite<D>& site);
};

}  // namespace seiche::solver
