#pragma once
#include "solver/boundary.hpp"
#include "solver/reference.hpp"

namespace seiche::solver {

/// Divergence of twice the strain rate at fluid particles, which is the velocity's Laplacian where nothing is
/// compressed [1/(m s)]: forces between pairs along their line (Monaghan & Gingold 1983, as an MPS sum),
///   (2d (d+2)/(lambda n0)) sum_j ((u_j - u_i).e) e w(r_ij),  e = r_ij/r_ij.
/// A free surface then bears no stress, as it must, and neither does a rigid rotation: a wave loses 2 nu k^2 of its
/// height in time, where the sum of equation (5), without stress only if du/dn = 0, takes nu k^2. On the square lattice
/// it is too strong along the axes and too weak across them by a tenth, which cancels in a wave.
/// A wall with `slip` bears the normal stress of the flow that it mirrors (divergence.hpp) and no shear; without, it
/// stands still. Walls count as far as they are wet.
template <int D, class K>
void strain_rate_divergence(const K& w, const Reference& ref, bool slip, const Neighbours<D>& list, const State<D>& s,
                            Vecs<D>& out) {
  const double factor = 2 * D * (D + 2) / (ref.lambda * ref.n0);
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    for (int j : list[i]) {
      const Vec<D> rij = s.position[j] - s.position[i];
      const double r = rij.norm();
      if (!(r < w.support)) continue;
      const double weight = s.wet[j] * w(r) / (r * r);
      if (slip && s.kind[j] != Kind::fluid) {
        const Vec<D>& normal = s.normal[j];
        const double across = normal.dot(rij);
        out[i] -= weight * 2 * s.velocity[i].dot(normal) * across * across * normal;
      } else {
        out[i] += weight * (s.velocity[j] - s.velocity[i]).dot(rij) * rij;
      }
    }
    out[i] *= factor;
  }
}

}  // namespace seiche::solver
