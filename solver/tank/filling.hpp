#pragma once
#include <algorithm>
#include <cmath>

#include "solver/operators/volume.hpp"
#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"
#include "solver/tank/level_axes.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// Longest support that an operator has [l0].
inline double longest_support(const Parameters::Method& m) {
  const double longest = std::max({m.radius_density, m.radius_gradient, m.radius_laplacian});
  return m.source == SourceTerm::mixed ? std::max(longest, VolumeKernel::radius) : longest;
}

/// Layers of particles outside the wall's surface: one of wall particles, and dummies enough to fill the longest
/// support of a wall particle.
inline int wall_layers(const Parameters::Method& m) { return 1 + static_cast<int>(std::floor(longest_support(m))); }

/// rho g (level - y), y the height along the level's axes [Pa]
inline double still_pressure(double density, const Gravity& gravity, double level, double y) {
  return density * gravity.size() * (level - y);
}

/// Fluid, wall and dummy particles of a tank whose liquid is at rest under what acts in it. Fluid has the first ids,
/// then walls, then dummies. A particle beyond a wall has its normal, out of the tank, or none where it is beyond an
/// edge.
template <int D>
State<D> fill_tank(const Parameters& p, const Shape<D>& tank, const RelativeEquilibrium& at_rest);

/// Under gravity alone.
template <int D>
State<D> fill_tank(const Parameters& p, const Shape<D>& tank) {
  return fill_tank<D>(p, tank, {p.gravity});
}

template <int D>
State<D> fill_tank(const Parameters& p) {
  return fill_tank<D>(p, *make_shape<D>(p));
}

}  // namespace seiche::solver
