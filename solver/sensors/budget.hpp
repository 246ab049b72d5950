#pragma once
#include <cmath>

#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"
#include "solver/rigid_state.hpp"
#include "solver/tank/level_axes.hpp"

namespace seiche::solver {

/// What the liquid has in all. Each particle has the mass rho l0^D.
template <int D>
struct Budget {
  double kinetic = 0;              ///< sum m u^2/2, u relative to the tank [J/m in 2-D, J]
  double potential = 0;            ///< sum m g (Y - still height), Y the height in the lab, against gravity [J/m, J]
  Vec<D> centre = Vec<D>::Zero();  ///< of mass, in the tank's frame; 0 when no liquid is left [m]
};

/// Mean height of the fluid particles along the level's axes [m]; 0 if there are none.
template <int D>
double mean_height(const State<D>& s, const Gravity& gravity) {
  const LevelAxes<D> axes(gravity);
  double sum = 0;
  long count = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) sum += axes.height(s.position[i]), ++count;
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
  // Y = y + displacement + (R - 1)(r - pivot), its part against gravity
  const auto n = static_cast<double>(count);
  const Eigen::Vector3d up = LevelAxes<3>(p.gravity).up(), turned = pose.orientation.conjugate() * up - up;
  const double risen = n * up.dot(pose.displacement) + turned.head<D>().dot(sum.centre - n * pose.pivot.head<D>());
  const double height = LevelAxes<D>(p.gravity).height(sum.centre);
  sum.potential = mass * p.gravity.size() * (height - still_height * n + risen);
  sum.centre /= static_cast<double>(count);
  return sum;
}

}  // namespace seiche::solver
