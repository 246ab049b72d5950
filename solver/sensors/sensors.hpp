#pragma once
#include <memory>
#include <vector>

#include "solver/frame.hpp"
#include "solver/motion/motion.hpp"
#include "solver/sensors/sensor.hpp"

namespace seiche::solver {

/// What sensors keep from one step to the next.
struct SensorMemory {
  Readings readings;      ///< not yet taken
  Scalars last;           ///< values at `last_time`
  double last_time = -1;  ///< [s]
  long next = 0;          ///< number of the next sample
};

/// The sensors of a run, read at exact multiples of the sample interval by linear interpolation between the states
/// before and after a step, and the tank's motion as it is at those times. Nothing is evaluated for steps without a
/// sample.
template <int D>
class Sensors {
 public:
  /// @param interval between two samples [s]; 0: no sensors
  Sensors(const SensorSite<D>& site, double interval);

  /// Call before a step that ends at `end` [s].
  void before_step(const State<D>& s, double end, SensorMemory& memory);

  /// Call with the state at t = 0 and after each step.
  /// Appends to memory.readings, in the order of `sensor_columns`.
  void read(const State<D>& s, SensorMemory& memory);

 private:
  bool is_due(double time, const SensorMemory& memory) const;
  void evaluate(const State<D>& s, Scalars& values);

  Parameters p_;
  double interval_;
  Motion motion_;
  FluidCells<D> cells_;
  SurfaceProfile<D> surface_;
  double still_height_;  ///< of the liquid's centre of mass [m]
  std::vector<std::unique_ptr<Sensor<D>>> sensors_;
  Scalars now_;  ///< a buffer
};

}  // namespace seiche::solver
