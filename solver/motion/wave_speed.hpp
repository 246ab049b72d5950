#pragma once
#include <algorithm>
#include <cmath>

#include "solver/motion/motion.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// From the pivot to the farthest corner of the bounds [m].
template <int D>
double reach_of(const Bounds<D>& bounds, const Parameters::Motion& motion) {
  const Vec<D> pivot = Eigen::Vector3d(motion.pivot_x, motion.pivot_y, motion.pivot_z).template head<D>();
  return (pivot - bounds.low).cwiseAbs().cwiseMax((bounds.high - pivot).cwiseAbs()).norm();
}

/// What pulls the liquid: gravity, or the tank's greatest acceleration where that is more [m/s^2].
template <int D>
double greatest_pull(const Parameters& p, const Bounds<D>& bounds, const Motion& motion) {
  return std::max(p.gravity.size(), motion.greatest_acceleration(reach_of(bounds, p.motion)));
}

/// sqrt(a H), the fastest wave on a depth H under the greatest pull a: the rates of the method scale with it [m/s].
template <int D>
double wave_speed(const Parameters& p, const Bounds<D>& bounds, const Motion& motion) {
  return std::sqrt(greatest_pull(p, bounds, motion) * p.fluid.depth);
}

}  // namespace seiche::solver
