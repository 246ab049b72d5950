#pragma once
#include <algorithm>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"

namespace seiche::solver {

/// A pressure sensor on a wall: at its point, or the mean over the part of the wall within side/2 of it on each axis
/// along the wall, by midpoints at most l0/2 apart. Either is exact on a linear field. A dry wall reads 0.
template <int D>
class PressureSensor {
 public:
  PressureSensor(const Parameters::PressureSensor& sensor, const Parameters& p) : l0_(p.particles.spacing) {
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
    double sum = 0;
    for (const Vec<D>& point : points_) sum += std::max(0.0, fit_pressure(point, l0_, s, cells).value);
    return sum / static_cast<double>(points_.size());
  }

 private:
  /// Replaces each point by midpoints of equal parts of what `side` covers along an axis of the wall.
  void spread(int axis, double side, double from, double to) {
    const Vecs<D> centres = std::move(points_);
    points_.clear();
    const double low = std::max(from, centres[0][axis] - 0.5 * side);
    const double high = std::min(to, centres[0][axis] + 0.5 * side);
    const int parts = std::max(1, static_cast<int>(std::ceil((high - low) / (0.5 * l0_) - 1e-9)));
    for (Vec<D> point : centres)
      for (int k = 0; k < parts; ++k) {
        point[axis] = low + (high - low) * (k + 0.5) / parts;
        points_.push_back(point);
      }
  }

  double l0_;
  Vecs<D> points_;
};

}  // namespace seiche::solver
