#pragma once
#include <algorithm>

#include "solver/operators/reference.hpp"
#include "solver/operators/rise_across.hpp"
#include "solver/particles/pairs.hpp"

// What bounds the liquid in the pressure equation. Each boundary answers: is the pressure of particle i unknown; what
// does its row gain on the diagonal by itself; and what does it gain on the diagonal and on the right-hand side from a
// neighbour j whose pressure is not an unknown.
namespace seiche::solver {

/// The paper's: wall particles are unknowns like the fluid, p = 0 at free-surface particles, dummies are left out.
template <int D>
struct PaperBoundary {
  const State<D>& s;
  bool unknown(int i) const { return s.kind[i] != Kind::dummy && !s.surface[i]; }
  double diagonal(int) const { return 0; }
  double pair_diagonal(int j, double weight) const { return s.kind[j] == Kind::dummy ? 0 : weight; }
  double pair_rhs(int, int, double, const Vec<D>&) const { return 0; }
};

/// The stabilised scheme's: fluid is unknown but for the free surface, whose pressures are given. Behind a wall the
/// pressure goes on with the slope that holds still liquid there, p_j = p_i + rho (f.n)(n.r_ij), f the body force: so a
/// hydrostatic field is exact, and gravity enters through the walls alone.
/// Beside the edge of a baffle liquid takes the place of what would balance the slope along it, so that there all of it
/// counts, p_j = p_i + rho f.r_ij.
/// The neighbours that a particle below the surface lacks, n0 - n_i in all, are air beyond p = 0; pressures that go on
/// linearly make them add 4/3 (n0 - n_i) p_i (a particle of the second layer lies 3/2 l0 below the zero, its air l0/2
/// above it), which also keeps p continuous as a particle leaves the surface. After Shibata et al. (2015).
template <int D>
struct GhostBoundary {
  const State<D>& s;
  const Scalars& density;                 ///< n_i
  const std::vector<std::uint8_t>& near;  ///< 1 near the surface
  double density_n0;                      ///< n0 that belongs to n_i
  double n0;                              ///< n0 of the Laplacian's own radius
  const Vecs<D>& slope;                   ///< rho f at each fluid particle [Pa/m]
  bool unknown(int i) const { return s.kind[i] == Kind::fluid && !s.surface[i]; }
  double diagonal(int i) const { return near[i] ? 4. / 3 * n0 * std::max(0.0, 1 - density[i] / density_n0) : 0; }
  double pair_diagonal(int j, double weight) const { return s.kind[j] == Kind::fluid ? weight : 0; }
  double pair_rhs(int i, int j, double weight, const Vec<D>& rij) const {
    if (s.kind[j] == Kind::fluid) return weight * s.pressure[j];
    if (s.in_baffle(j)) return weight * slope[i].dot(rij);
    return weight * rise_across(s.normal_from(s.position[i], j), slope[i], rij);
  }
};

/// Pressure at wall particles [Pa], for sensors and pictures: the mean over the fluid around of what each would have
/// behind the wall. 0 where there is no fluid.
/// @param slope rho f at each fluid particle [Pa/m]
template <int D>
void extend_to_walls(const Pairs<D>& pairs, const Vecs<D>& slope, State<D>& s) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    if (s.kind[i] != Kind::wall) continue;
    double sum = 0, weights = 0;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      if (s.kind[j] != Kind::fluid) return;
      const double w = weight * rij.squaredNorm();
      sum += w * (s.pressure[j] - rise_across(s.normal_from(s.position[j], i), slope[j], rij));
      weights += w;
    });
    s.pressure[i] = weights > 0 ? sum / weights : 0;
  }
}

}  // namespace seiche::solver
