#pragma once
#include <cmath>

#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// What the liquid has in all, in the tank's frame. Each particle has the mass rho l0^D.
template <int D>
struct Budget {
  double kinetic = 0;              ///< sum m u^2/2, u relative to the tank [J/m in 2-D, J]
  double potential = 0;            ///< sum m g (y - depth/2): 0 for the still liquid that fills the tank [J/m, J]
  Vec<D> centre = Vec<D>::Zero();  ///< of mass; 0 when no liquid is left [m]
};

template <int D>
Budget<D> budget(const State<D>& s, const Parameters& p) {
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
  sum.potential = mass * p.gravity * (sum.centre[1] - 0.5 * p.fluid.depth * static_cast<double>(count));
  sum.centre /= static_cast<double>(count);
  return sum;
}

}  // namespace seiche::solver
