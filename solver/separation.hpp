#pragma once
#include "solver/neighbours.hpp"

namespace seiche::solver {

/// The paper's additional modification (Figure 4): a pair closer than `distance` is parted to that distance along its
/// line, each fluid particle by half of what lacks, or all of it where the other is a wall. `moved` is a buffer.
template <int D>
void part_close_pairs(double distance, const Neighbours<D>& list, State<D>& s, Vecs<D>& moved) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    moved[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    for (int j : list[i]) {
      const Vec<D> rij = s.position[j] - s.position[i];
      const double r = rij.norm();
      if (r < distance) moved[i] -= (s.kind[j] == Kind::fluid ? 0.5 : 1.0) * (distance / r - 1) * rij;
    }
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) s.position[i] += moved[i];
}

/// Perfectly inelastic collision: a pair closer than `distance` that approaches loses its velocity of approach, shared
/// equally between two fluid particles (momentum is kept), wholly taken by the one that meets a wall. Koshizuka & Oka
/// (1996) use such a collision at 0.5 l0. `change` is a buffer.
template <int D>
void collide_close_pairs(double distance, const Neighbours<D>& list, State<D>& s, Vecs<D>& change) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    change[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    for (int j : list[i]) {
      const Vec<D> rij = s.position[j] - s.position[i];
      const double r2 = rij.squaredNorm();
      if (!(r2 < distance * distance)) continue;
      const double approach = (s.velocity[j] - s.velocity[i]).dot(rij);
      if (approach < 0) change[i] += (s.kind[j] == Kind::fluid ? 0.5 : 1.0) * approach / r2 * rij;
    }
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) s.velocity[i] += change[i];
}

/// Particle shifting: each fluid particle away from the free surface (`near` 0) moves by
/// -strength l0^2 (d/n0) sum_j r_ij w/r_ij^2, towards where neighbours are sparse (after Xu, Stansby, Laurence 2009).
/// Velocities stay. `moved` is a buffer.
template <int D, class K>
void shift_particles(const K& w, double n0, double strength, double l0, const Neighbours<D>& list,
                     const std::vector<std::uint8_t>& near, State<D>& s, Vecs<D>& moved) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    moved[i].setZero();
    if (s.kind[i] != Kind::fluid || near[i]) continue;
    for (int j : list[i]) {
      const Vec<D> rij = s.position[j] - s.position[i];
      const double r2 = rij.squaredNorm();
      if (r2 < w.support * w.support) moved[i] -= w(std::sqrt(r2)) / r2 * rij;
    }
    moved[i] *= strength * l0 * l0 * D / n0;
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) s.position[i] += moved[i];
}

}  // namespace seiche::solver
