#pragma once
#include <cmath>

#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// What the liquid has in all. Each particle has the mass rho l0^D.
template <int D>
struct Budget {
  double kinetic = 0;              ///< sum m u^2/2, u relative to the tank [J/m in 2-D, J]
  double potential = 0;            ///< sum m g (Y - depth/2), Y the height in the lab: 0 for still liquid [J/m, J]
  Vec<D> centre = Vec<D>::Zero();  ///< of mass, in the tank's frame; 0 when no liquid is left [m]
};

template <int D>
Budget<D> budget(const State<D>& s, const Parameters& p, const RigidState& pose) {
  Budget<D> sum;
  long count = 0;
  double squares = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.kind[i] != Kind::fluid) continue;
    ++count;
    squares += s.velocity[i].squaredNorm();
    sum.centre += s.position[i];
  }
  if (count == 0) return sum;
  const double mass = p.fluid.density * std::pow(p.particles.spacing, D);
  sum.kinetic = 0.5 * mass * squares;
  // Y = y + displacement + (R - 1)(r - pivot), its part along y
  const auto n = static_cast<double>(count);
  const Eigen::Vector3d up = pose.orientation.conjugate() * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitY();
  const double risen = n * pose.displacement[1] + up.head<D>().dot(sum.centre - n * pose.pivot.head<D>());
  sum.potential = mass * p.gravity * (sum.centre[1] - 0.5 * p.fluid.depth * n + risen);
  sum.centre /= static_cast<double>(count);
  return sum;
}

}  // namespace seiche::solver
