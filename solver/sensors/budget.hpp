#pragma once
#include <cmath>

#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// What the liquid has in all. Each particle has the mass rho l0^D.
template <int D>
struct Budget {
  double kinetic = 0;              ///< sum m u^2/2, u relative to the tank [J/m in 2-D, J]
  double potential = 0;            ///< sum m g (Y - still height), Y the height in the lab [J/m, J]
  Vec<D> centre = Vec<D>::Zero();  ///< of mass, in the tank's frame; 0 when no liquid is left [m]
};

/// Mean height of the fluid particles [m]; 0 if there are none.
template <int D>
double mean_height(const State<D>& s) {
  double sum = 0;
  long count = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) sum += s.position[i][1], ++count;
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// @param still_height of the centre of mass of still liquid [m]
template <int D>
Budget<D> budget(const State<D>& s, const Parameters& p, double still_height, const RigidState& pose) {
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
  sum.potential = mass * p.gravity * (sum.centre[1] - still_height * n + risen);
  sum.centre /= static_cast<double>(count);
  return sum;
}

}  // namespace seiche::solver
