#pragma once
#include "solver/neighbours.hpp"
#include "solver/reference.hpp"

namespace seiche::solver {

/// Particle number density, equation (3): n_i = sum_j w(r_ij), and the number of neighbours within the support.
/// All kinds count, walls as far as they are wet (in the number: if more than half); 0 at dummies.
template <int D, class K>
void number_density(const K& w, const Neighbours<D>& list, const State<D>& s, Scalars& n, std::vector<int>& count) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    double sum = 0;
    int near = 0;
    for (int j : list[i]) {
      const double d = (s.position[j] - s.position[i]).norm();
      if (!(d < w.support)) continue;
      sum += s.wet[j] * w(d);
      near += s.wet[j] > 0.5;
    }
    n[i] = sum;
    count[i] = near;
  }
}

/// Free surface, equation (11): n_i < beta n0. With `count_share` > 0 the particle must also have at most that share
/// of the full lattice's neighbours: weighing and counting together stop the flicker that comes from weighing alone
/// (after Tanaka & Masunaga 2010). Wall particles are judged alike; dummies never.
inline void mark_free_surface(const Reference& ref, double beta, double count_share, const Scalars& n,
                              const std::vector<int>& count, const std::vector<Kind>& kind,
                              std::vector<std::uint8_t>& surface) {
  const int most_count = static_cast<int>(count_share * ref.count + 1e-9);
  for (std::size_t i = 0; i < n.size(); ++i)
    surface[i] = kind[i] != Kind::dummy && n[i] < beta * ref.n0 && (count_share == 0 || count[i] <= most_count);
}

/// 1 at the free surface and wherever a neighbour within `reach` is on it.
template <int D>
void mark_near_surface(double reach, const Neighbours<D>& list, const Vecs<D>& r,
                       const std::vector<std::uint8_t>& surface, std::vector<std::uint8_t>& near) {
  const int size = static_cast<int>(r.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    near[i] = surface[i];
    for (int j : list[i])
      if (surface[j] && (r[j] - r[i]).squaredNorm() < reach * reach) near[i] = 1;
  }
}

}  // namespace seiche::solver
