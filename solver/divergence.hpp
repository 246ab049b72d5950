#pragma once
#include "solver/neighbours.hpp"

namespace seiche::solver {

/// Divergence of the velocity at fluid and wall particles [1/s]:
/// (d/n0) sum_j (u_j - u_i).r_ij w/r_ij^2 (Tanaka & Masunaga 2010, Khayyer & Gotoh 2009). Walls stand still; of a pair
/// of fluid and wall only the velocity along the wall's normal counts, so that fluid may slide. Pairs of wall particles
/// add nothing.
template <int D, class K>
void velocity_divergence(const K& w, double n0, const Neighbours<D>& list, const State<D>& s, Scalars& out) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i] = 0;
    const bool fluid = s.kind[i] == Kind::fluid;
    for (int j : list[i]) {
      const bool fluid_j = s.kind[j] == Kind::fluid;
      if (!fluid && !fluid_j) continue;
      const Vec<D> rij = s.position[j] - s.position[i];
      const double r2 = rij.squaredNorm();
      if (!(r2 < w.support * w.support)) continue;
      double rate;
      if (fluid && fluid_j) {
        rate = (s.velocity[j] - s.velocity[i]).dot(rij);
      } else {
        const Vec<D>& normal = fluid ? s.normal[j] : s.normal[i];
        const Vec<D> du = s.velocity[j] - s.velocity[i];
        rate = normal.isZero() ? du.dot(rij) : du.dot(normal) * normal.dot(rij);
      }
      out[i] += rate * w(std::sqrt(r2)) / r2;
    }
    out[i] *= D / n0;
  }
}

}  // namespace seiche::solver
