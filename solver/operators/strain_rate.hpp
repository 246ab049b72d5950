#pragma once
#include "solver/operators/reference.hpp"
#include "solver/operators/rise_across.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// Divergence of twice the strain rate at fluid particles, which is the velocity's Laplacian where nothing is
/// compressed [1/(m s)]: forces between pairs along their line (Monaghan & Gingold 1983, as an MPS sum),
///   (2d (d+2)/(lambda n0)) sum_j ((u_j - u_i).e) e w(r_ij),  e = r_ij/r_ij.
/// A free surface then bears no stress, as it must, and neither does a rigid rotation: a wave loses 2 nu k^2 of its
/// height in time, where the sum of equation (5), without stress only if du/dn = 0, takes nu k^2. On the square lattice
/// it is too strong along the axes and too weak across them by a tenth, which cancels in a wave.
/// A wall with `slip` bears the normal stress of the flow that it mirrors (divergence.hpp) and no shear; without, it
/// stands still. Walls count as far as they are wet.
template <int D>
void strain_rate_divergence(const Pairs<D>& pairs, const Reference& ref, bool slip, const State<D>& s, Vecs<D>& out) {
  const double factor = 2 * D * (D + 2) / (ref.lambda * ref.n0);
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    const Vec<D> ui = s.velocity[i];
    Vec<D> sum = Vec<D>::Zero();
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      const bool wall = s.kind[j] != Kind::fluid;
      if (wall) weight *= s.wet[j];
      if (slip && wall) {
        const Vec<D> normal = s.normal_from(s.position[i], j);
        const double across = normal.dot(rij);
        sum -= weight * 2 * ui.dot(normal) * across * across * normal;
      } else {
        sum += weight * (s.velocity[j] - ui).dot(rij) * rij;
      }
    });
    out[i] = factor * sum;
  }
}

}  // namespace seiche::solver
