#pragma once
#include <algorithm>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/sensors/sensor_list.hpp"

namespace seiche::solver {

/// A pressure sensor, at a point of the wall or inside the liquid: at its point, or over the part of the wall within
/// side/2 of it along two directions square to each other, which is cut into parts at most l0/2 long: the mean of their
/// midpoints, or the maximum of their ends, corners of the area included. Each is exact on a linear field where the
/// wall is flat. A dry wall reads 0.
template <int D>
class PressureSensor {
 public:
  PressureSensor(const Parameters::PressureSensor& sensor, const Shape<D>& tank, double l0)
      : l0_(l0), reading_(sensor.reading) {
    const Vec<D> place = Vec<3>(sensor.x, sensor.y, sensor.z).head<D>();
    const Nearest<D> wall = tank.nearest(place);
    const bool on_wall = wall.distance > -on_wall_within * l0;
    if (on_wall) to_eye_ = -eye_distance * l0 * wall.normal;
    points_.push_back(on_wall ? wall.foot : place);
    if (on_wall && sensor.side > 0)
      for (const Vec<D>& way : along(wall.normal)) spread(tank, wall, way, sensor.side);
  }

  /// A point nearer to the wall is on it [l0].
  static constexpr double on_wall_within = 0.5;

  /// [Pa]
  double read(const State<D>& s, const FluidCells<D>& cells) const {
    double sum = 0, highest = 0;
    for (const Vec<D>& point : points_) {
      const double pressure = std::max(0.0, fit_pressure(point, Vec<D>(point + to_eye_), l0_, s, cells).value);
      sum += pressure;
      highest = std::max(highest, pressure);
    }
    if (reading_ == PressureReading::maximum) return highest;
    return sum / static_cast<double>(points_.size());
  }

 private:
  /// Unit vectors along the wall, square to each other; along the axes where the wall is.
  static std::vector<Vec<D>> along(const Vec<D>& normal) {
    std::vector<Vec<D>> ways;
    for (int axis = 0; axis < D && ways.size() + 1 < D; ++axis) {
      Vec<D> way = Vec<D>::Unit(axis) - normal[axis] * normal;
      for (const Vec<D>& other : ways) way -= way.dot(other) * other;
      if (way.norm() > 0.5) ways.push_back(way.normalized());
    }
    return ways;
  }

  /// Whether the wall goes on there as the one at `wall`, within 45 degrees: another begins beyond a sharper edge.
  static bool goes_on(const Shape<D>& tank, const Nearest<D>& wall, const Vec<D>& r) {
    return tank.nearest(r).normal.dot(wall.normal) > std::sqrt(0.5);
  }

  /// How far from the wall's point it goes on along a way, up to `most` [m].
  static double extent(const Shape<D>& tank, const Nearest<D>& wall, const Vec<D>& way, double most) {
    double low = 0, high = most;
    if (goes_on(tank, wall, wall.foot + most * way)) return most;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (goes_on(tank, wall, wall.foot + middle * way) ? low : high) = middle;
    }
    return low;
  }

  /// Replaces each point by midpoints or ends of equal parts of what `side` covers along a way, put onto the wall.
  void spread(const Shape<D>& tank, const Nearest<D>& wall, const Vec<D>& way, double side) {
    const Vecs<D> centres = std::move(points_);
    points_.clear();
    const double low = -extent(tank, wall, -way, 0.5 * side), high = extent(tank, wall, way, 0.5 * side);
    const int parts = std::max(1, static_cast<int>(std::ceil((high - low) / (0.5 * l0_) - 1e-9)));
    const bool ends = reading_ == PressureReading::maximum;
    for (const Vec<D>& centre : centres)
      for (int k = 0; k < parts + ends; ++k) {
        const Vec<D> point = centre + (low + (high - low) * (ends ? k : k + 0.5) / parts) * way;
        const Nearest<D> here = tank.nearest(point);
        points_.push_back(here.normal.dot(wall.normal) > std::sqrt(0.5) ? here.foot : point);
      }
  }

  double l0_;
  PressureReading reading_;
  Vec<D> to_eye_ = Vec<D>::Zero();  ///< from a point on the wall [m]
  Vecs<D> points_;
};

/// All that the scene names.
template <int D>
class PressureSensors : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    std::vector<Column> all;
    const double scale = Scales(p).pressure;
    for (const auto& sensor : sensors_of(p).pressure) {
      const bool mean = sensor.reading == PressureReading::mean;
      all.push_back({(mean ? "p_" : "p_max_") + sensor.name, "Pa",
                     (mean ? "pressure, " : "maximum pressure, ") + in_words(sensor.name), ColumnKind::pressure,
                     Rest::first_value, scale});
    }
    return all;
  }

  explicit PressureSensors(const SensorSite<D>& site) {
    for (const auto& sensor : sensors_of(site.p).pressure)
      sensors_.emplace_back(sensor, site.tank, site.p.particles.spacing);
  }

  void read(const Instant<D>& now, Scalars& values) override {
    for (const auto& sensor : sensors_) values.push_back(sensor.read(now.s, now.cells));
  }

 private:
  std::vector<PressureSensor<D>> sensors_;
};

}  // namespace seiche::solver
