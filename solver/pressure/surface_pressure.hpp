#pragma once
#include <algorithm>

#include "solver/operators/reference.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// How far below the free surface the centre of a particle at it lies [m]: l0/2 in the topmost layer, less in
/// proportion to its number density n for drops and films.
struct SurfaceDepth {
  double l0, topmost;  ///< spacing [m] and the topmost layer's density, on the lattice

  double operator()(double n) const { return 0.5 * l0 * std::min(1.0, n / topmost); }
};

/// For a kernel in D dimensions.
template <int D, class K>
SurfaceDepth surface_depth(const K& w, double l0) {
  // Half of what is there beside its own layer, and its layer.
  return {l0, 0.5 * (lattice_reference<D>(w, l0).n0 + lattice_reference<D - 1>(w, l0).n0)};
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
