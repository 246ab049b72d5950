#pragma once
#include <algorithm>
#include <cmath>

#include "solver/operators/volume.hpp"
#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"
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

/// Fluid, wall and dummy particles of a tank at rest on one lattice, l0/2 off the wall's surface; the fluid's pressure
/// is hydrostatic. Fluid has the first ids, then walls, then dummies. A particle beyond a wall has its normal, out of
/// the tank, or none where it is beyond an edge.
template <int D>
State<D> fill_tank(const Parameters& p) {
  const auto shape = make_shape<D>(p);
  const Bounds<D> bounds = shape->bounds();
  const double l0 = p.particles.spacing;
  const int layers = wall_layers(p.method);
  const double column = p.fluid.column > 0 ? p.fluid.column : bounds.size()[0];
  using Cell = Eigen::Matrix<int, D, 1>;
  const Cell first = (bounds.low.array() / l0).round().template cast<int>() - layers;
  Cell last = (bounds.high.array() / l0).round().template cast<int>() + layers;
  if (!shape->is_closed()) last[1] -= layers;

  State<D> fluids, walls, dummies;
  for (Cell c = first; c[D - 1] < last[D - 1];) {
    const Vec<D> r = (c.template cast<double>().array() + 0.5) * l0;
    const Nearest<D> wall = shape->nearest(r);
    if (wall.distance < 0) {
      if (r[1] < p.fluid.depth && r[0] < bounds.low[0] + column) {
        fluids.add(r, Kind::fluid, Vec<D>::Zero());
        fluids.pressure.back() = p.fluid.density * p.gravity * (p.fluid.depth - r[1]);
      }
    } else {
      const bool beyond_edge = (r - wall.foot - wall.distance * wall.normal).norm() > 1e-6 * l0;
      (wall.distance < l0 ? walls : dummies)
          .add(r, wall.distance < l0 ? Kind::wall : Kind::dummy, beyond_edge ? Vec<D>(Vec<D>::Zero()) : wall.normal);
    }
    for (int a = 0; ++c[a] == last[a] && a < D - 1; ++a) c[a] = first[a];
  }
  for (const State<D>* more : {&walls, &dummies})
    for (std::size_t i = 0; i < more->size(); ++i) fluids.add(more->position[i], more->kind[i], more->normal[i]);
  return fluids;
}

}  // namespace seiche::solver
