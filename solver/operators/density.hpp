#pragma once
#include "solver/operators/reference.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// Particle number density, equation (3): n_i = sum_j w(r_ij), and the number of neighbours within the support.
/// All kinds count, walls as far as they are wet (in the number: by their volume, if more than half is); 0 at dummies.
template <int D>
void number_density(const Pairs<D>& pairs, const State<D>& s, Scalars& n, Scalars& count) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    double sum = 0;
    double near = 0;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      sum += s.wet[j] * weight * rij.squaredNorm();
      near += s.wet[j] > 0.5 * s.volume[j] ? s.volume[j] : 0;
    });
    n[i] = sum;
    count[i] = near;
  }
}

/// Share of the full neighbour count up to which a particle may be at the free surface (Tanaka & Masunaga 2010).
inline constexpr double count_share = 0.85;

/// Free surface, equation (11): n_i < beta n0. With `most_share` > 0 the particle must also have at most that share
/// of the full lattice's neighbours: weighing and counting together stop the flicker that comes from weighing alone
/// (after Tanaka & Masunaga 2010). Wall particles are judged alike; dummies never.
inline void mark_free_surface(const Reference& ref, double beta, double most_share, const Scalars& n,
                              const Scalars& count, const std::vector<Kind>& kind, std::vector<std::uint8_t>& surface) {
  const int most_count = static_cast<int>(most_share * ref.count + 1e-9);
  for (std::size_t i = 0; i < n.size(); ++i)
    surface[i] = kind[i] != Kind::dummy && n[i] < beta * ref.n0 && (most_share == 0 || count[i] <= most_count);
}

/// 1 at the free surface and wherever a neighbour is on it. Found from the surface, of which there is little: pairs
/// hold both ways.
template <int D>
void mark_near_surface(const Pairs<D>& pairs, const State<D>& s, std::vector<std::uint8_t>& near) {
  near = s.surface;
  const int size = static_cast<int>(s.size());
  for (int i = 0; i < size; ++i) {
    if (!s.surface[i]) continue;
    for (int j : pairs[i]) near[j] |= s.kind[j] != Kind::dummy;
  }
}

}  // namespace seiche::solver
