#pragma once
#include <algorithm>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/sensors/sensor_list.hpp"

namespace seiche::solver {

/// A pressure sensor on a wall: at its point, or over the part of the wall within side/2 of it on each axis along the
/// wall, which is cut into parts at most l0/2 long: the mean of their midpoints, or the maximum of their ends, corners
/// of the area included. Each is exact on a linear field. A dry wall reads 0.
template <int D>
class PressureSensor {
 public:
  PressureSensor(const Parameters::PressureSensor& sensor, const Parameters& p)
      : l0_(p.particles.spacing), reading_(sensor.reading) {
    const auto tank = make_shape<D>(p);
    const Bounds<D> bounds = tank->bounds();
    points_.push_back(Vec<3>(sensor.x, sensor.y, sensor.z).head<D>());
    int wall;
    tank->nearest(points_[0]).normal.cwiseAbs().maxCoeff(&wall);
    for (int a = 0; a < D; ++a)
      if (a != wall && sensor.side > 0) spread(a, sensor.side, bounds.low[a], bounds.high[a]);
  }

  /// [Pa]
  double read(const State<D>& s, const FluidCells<D>& cells) const {
    double sum = 0, highest = 0;
    for (const Vec<D>& point : points_) {
      const double pressure = std::max(0.0, fit_pressure(point, l0_, s, cells).value);
      sum += pressure;
      highest = std::max(highest, pressure);
    }
    if (reading_ == PressureReading::maximum) return highest;
    return sum / static_cast<double>(points_.size());
  }

 private:
  /// Replaces each point by midpoints or ends of equal parts of what `side` covers along an axis of the wall.
  void spread(int axis, double side, double from, double to) {
    const Vecs<D> centres = std::move(points_);
    points_.clear();
    const double low = std::max(from, centres[0][axis] - 0.5 * side);
    const double high = std::min(to, centres[0][axis] + 0.5 * side);
    const int parts = std::max(1, static_cast<int>(std::ceil((high - low) / (0.5 * l0_) - 1e-9)));
    const bool ends = reading_ == PressureReading::maximum;
    for (Vec<D> point : centres)
      for (int k = 0; k < parts + ends; ++k) {
        point[axis] = low + (high - low) * (ends ? k : k + 0.5) / parts;
        points_.push_back(point);
      }
  }

  double l0_;
  PressureReading reading_;
  Vecs<D> points_;
};

/// All that the scene names.
template <int D>
class PressureSensors : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    std::vector<Column> all;
    for (const auto& sensor : sensors_of(p).pressure) {
      const bool mean = sensor.reading == PressureReading::mean;
      all.push_back({(mean ? "p_" : "p_max_") + sensor.name, "Pa",
                     (mean ? "pressure, " : "maximum pressure, ") + in_words(sensor.name), ColumnKind::pressure,
                     Rest::first_value, Scales(p).pressure});
    }
    return all;
  }

  PressureSensors(const Parameters& p, const State<D>&) {
    for (const auto& sensor : sensors_of(p).pressure) sensors_.emplace_back(sensor, p);
  }

  void read(const Instant<D>& now, Scalars& values) override {
    for (const auto& sensor : sensors_) values.push_back(sensor.read(now.s, now.cells));
  }

 private:
  std::vector<PressureSensor<D>> sensors_;
};

}  // namespace seiche::solver
