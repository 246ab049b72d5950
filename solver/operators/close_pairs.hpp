#pragma once
#include "solver/particles/pairs.hpp"

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
/// (1996) use such a collision at 0.5 l0. Where both are near the free surface the distance is l0 at least: with p
/// given there, pressure can't keep those particles at their spacing. All pairs act at once, so each is weakened by the
/// number of collisions of its busier partner: energy can only fall. `collisions` and `change` are buffers.
template <int D>
void collide_close_pairs(double distance, double l0, const std::vector<std::uint8_t>& near, const Neighbours<D>& list,
                         State<D>& s, std::vector<int>& collisions, Vecs<D>& change) {
  const int size = static_cast<int>(s.size());
  const auto each_collision = [&](int i, auto f) {
    for (int j : list[i]) {
      const Vec<D> rij = s.position[j] - s.position[i];
      const double reach = near[i] && near[j] ? std::max(distance, l0) : distance;
      const double r2 = rij.squaredNorm(), approach = (s.velocity[j] - s.velocity[i]).dot(rij);
      if (r2 < reach * reach && approach < 0) f(j, Vec<D>(approach / r2 * rij));
    }
  };
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    collisions[i] = 0;
    if (s.kind[i] == Kind::fluid) each_collision(i, [&](int, const Vec<D>&) { ++collisions[i]; });
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    change[i].setZero();
    if (s.kind[i] != Kind::fluid || collisions[i] == 0) continue;
    each_collision(i, [&](int j, const Vec<D>& velocity) {
      change[i] += (s.kind[j] == Kind::fluid ? 0.5 : 1.0) / std::max(collisions[i], collisions[j]) * velocity;
    });
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) s.velocity[i] += change[i];
}

}  // namespace seiche::solver
