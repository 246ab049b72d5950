#pragma once
#include <algorithm>

#include "solver/operators/reference.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// How far below the free surface a particle of number density n lies [m]: l0/2 in the topmost layer under a flat
/// surface, 3/2 l0 in the second, between them l0/2 + l0 q^4, q the share of the way from the density of the one to
/// that of the other; less than l0/2 in proportion to n for drops and films. The second layer's density is hardly below
/// n0: there flags come and go, and so that pressure doesn't jump with them, its depth must be the true one. The fourth
/// power leaves the topmost layer, whose density disorder changes most, its flat surface; a square damps waves more.
struct SurfaceDepth {
  double l0, topmost, second;  ///< spacing [m] and the densities of the two layers, on the lattice

  double operator()(double n) const {
    if (n < topmost) return 0.5 * l0 * n / topmost;
    const double q = std::min(1.0, (n - topmost) / (second - topmost));
    return l0 * (0.5 + q * q * q * q);
  }
};

/// For a kernel in D dimensions.
template <int D, class K>
SurfaceDepth surface_depth(const K& w, double l0) {
  // A layer one spacing away: what it adds to a particle's number density.
  double beside = 0;
  const int m = static_cast<int>(std::ceil(w.support / l0));
  for (int k = D == 3 ? -m : 0; k <= (D == 3 ? m : 0); ++k)
    for (int i = -m; i <= m; ++i)
      if (const double r = l0 * std::sqrt(1.0 + double(i) * i + double(k) * k); r < w.support) beside += w(r);
  // Half of what is there beside its own layer, and its layer.
  const double topmost = 0.5 * (lattice_reference<D>(w, l0).n0 + lattice_reference<D - 1>(w, l0).n0);
  return {l0, topmost, topmost + beside};
}

/// Gives free-surface particles the pressure that holds what lies above their centres: rho times their depth times the
/// acceleration that the body force f and the viscous force give along f; 0 at walls, and where it would be suction.
/// The viscous force brings in the normal viscous stress, p = 2 rho nu du_n/dn below a surface that bears none: a sum
/// over pairs puts it on the topmost layer, half of it above the centres.
/// @param rho of the liquid [kg/m^3]; 0 gives p = 0
/// @param force f, `viscous` the viscous force per mass, at each fluid particle [m/s^2]
template <int D>
void set_surface_pressure(double rho, const Vecs<D>& force, const Vecs<D>& viscous, const SurfaceDepth& depth,
                          const Scalars& density, State<D>& s) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    if (!s.surface[i]) continue;
    const double f = force[i].norm();
    const double held = s.kind[i] == Kind::fluid && f > 0 ? f + viscous[i].dot(force[i]) / f : 0;
    s.pressure[i] = rho * depth(density[i]) * std::max(0.0, held);
  }
}

}  // namespace seiche::solver
