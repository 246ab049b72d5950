#pragma once
#include <algorithm>
#include <cmath>

#include "solver/operators/volume.hpp"
#include "solver/parameters.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// The inner box of a tank, and what belongs to its fluid.
template <int D>
struct Box {
  Vec<D> size;  ///< inner length, height(, width) [m]; a corner stands at the origin
  bool closed;
  double spacing;  ///< l0 [m]

  explicit Box(const Parameters& p) : closed(p.tank.closed), spacing(p.particles.spacing) {
    size[0] = p.tank.length;
    size[1] = p.tank.height;
    if constexpr (D == 3) size[2] = p.tank.width;
  }

  double diagonal() const { return size.norm(); }

  /// Past the centres of the wall particles, l0/2 behind the wall's surface; the open side of a tank has no end.
  bool has_leaked(const Vec<D>& r) const {
    const double slack = 0.5 * spacing;
    for (int a = 0; a < D; ++a) {
      const bool through_low = r[a] < -slack && (a == 1 || within_height(r));
      const bool through_high = r[a] > size[a] + slack && (a == 1 ? closed : within_height(r));
      if (through_low || through_high) return true;
    }
    return false;
  }

  /// Over the rim of an open tank and beside it.
  bool has_spilled(const Vec<D>& r) const {
    if (closed || within_height(r)) return false;
    for (int a = 0; a < D; ++a)
      if (a != 1 && (r[a] < -0.5 * spacing || r[a] > size[a] + 0.5 * spacing)) return true;
    return false;
  }

 private:
  bool within_height(const Vec<D>& r) const { return closed || r[1] <= size[1]; }
};

/// Longest support that an operator has [l0].
inline double longest_support(const Parameters::Method& m) {
  const double longest = std::max({m.radius_density, m.radius_gradient, m.radius_laplacian});
  return m.source == SourceTerm::mixed ? std::max(longest, VolumeKernel::radius) : longest;
}

/// Layers of particles outside the wall's surface: one of wall particles, and dummies enough to fill the longest
/// support of a wall particle.
inline int wall_layers(const Parameters::Method& m) { return 1 + static_cast<int>(std::floor(longest_support(m))); }

/// Fluid, wall and dummy particles of a tank at rest on one lattice, l0/2 off the wall's surface; the fluid's pressure
/// is hydrostatic. Fluid has the first ids, then walls, then dummies.
template <int D>
State<D> fill_tank(const Parameters& p) {
  const double l0 = p.particles.spacing;
  const auto cells = [l0](double length) { return static_cast<int>(std::lround(length / l0)); };
  const int layers = wall_layers(p.method);
  const double column = p.fluid.column > 0 ? p.fluid.column : p.tank.length;
  using Cell = Eigen::Matrix<int, D, 1>;
  Cell tank, fluid, first = Cell::Constant(-layers), last;
  tank[0] = cells(p.tank.length);
  tank[1] = cells(p.tank.height);
  fluid[0] = cells(column);
  fluid[1] = cells(p.fluid.depth);
  if constexpr (D == 3) fluid[2] = tank[2] = cells(p.tank.width);
  last = tank.array() + layers;
  if (!p.tank.closed) last[1] = tank[1];

  State<D> fluids, walls, dummies;
  for (Cell c = first; c[D - 1] < last[D - 1];) {
    const Vec<D> r = (c.template cast<double>().array() + 0.5) * l0;
    Vec<D> normal = Vec<D>::Zero();
    int outside = 0;
    for (int a = 0; a < D; ++a) {
      if (c[a] < 0) normal[a] = -1, outside = std::max(outside, -c[a]);
      if (c[a] >= tank[a]) normal[a] = 1, outside = std::max(outside, c[a] - tank[a] + 1);
    }
    if (outside == 0) {
      if ((c.array() < fluid.array()).all()) {
        fluids.add(r, Kind::fluid, normal);
        fluids.pressure.back() = p.fluid.density * p.gravity * (p.fluid.depth - r[1]);
      }
    } else {
      (outside == 1 ? walls : dummies)
          .add(r, outside == 1 ? Kind::wall : Kind::dummy, normal.squaredNorm() > 1 ? Vec<D>(Vec<D>::Zero()) : normal);
    }
    for (int a = 0; ++c[a] == last[a] && a < D - 1; ++a) c[a] = first[a];
  }
  for (const State<D>* more : {&walls, &dummies})
    for (std::size_t i = 0; i < more->size(); ++i) fluids.add(more->position[i], more->kind[i], more->normal[i]);
  return fluids;
}

}  // namespace seiche::solver
