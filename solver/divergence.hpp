#pragma once
#include "solver/boundary.hpp"

namespace seiche::solver {

/// Divergence of the velocity at fluid and wall particles [1/s]:
/// (d/n0) sum_j (u_j - u_i).r_ij w/r_ij^2 (Khayyer & Gotoh 2009, Tanaka & Masunaga 2010). Walls stand still. Behind one
/// the fluid's velocity along the normal goes on mirrored, u_j.n = -u_i.n, so that over the layers beside a wall the
/// sum is the flow that the wall stops, all of it; along the wall nothing counts, so that fluid may slide.
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
      const Vec<D> du = s.velocity[j] - s.velocity[i];
      const double rate = fluid && fluid_j ? du.dot(rij) : 2 * rise_across(fluid ? s.normal[j] : s.normal[i], du, rij);
      out[i] += rate * w(std::sqrt(r2)) / r2;
    }
    out[i] *= D / n0;
  }
}

}  // namespace seiche::solver
