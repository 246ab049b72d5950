#pragma once
#include "solver/operators/reference.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// Laplacian of the velocity at fluid particles, equation (5) with the factor 2 of Koshizuka & Oka (1996):
/// (2d/(lambda n0)) sum_j (u_j - u_i) w(r_ij) [1/(m s)]; exact on quadratic fields on a lattice.
/// Walls and dummies stand still; with `slip` they exert no shear and are left out; without, as far as
/// they are wet.
template <int D>
void velocity_laplacian(const Pairs<D>& pairs, const Reference& ref, bool slip, const State<D>& s, Vecs<D>& out) {
  const double factor = 2 * D / (ref.lambda * ref.n0);
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    Vec<D> sum = Vec<D>::Zero();
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      if (slip && s.kind[j] != Kind::fluid) return;
      sum += s.wet[j] * weight * rij.squaredNorm() * (s.velocity[j] - s.velocity[i]);
    });
    out[i] = factor * sum;
  }
}

}  // namespace seiche::solver
