#pragma once
#include <algorithm>
#include <cmath>

#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// The paper's additional modification (Figure 4): a pair closer than `distance` is parted to that distance along its
/// line, each fluid particle by half of what lacks, or all of it where the other is a wall. `moved` is a buffer.
template <int D>
void part_close_pairs(double distance, const Neighbours<D>& list, State<D>& s, Vecs<D>& moved) {
  const int size = static_cast<int>(s.size());
  resize_kept(moved, s.size());
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

/// Buffers of collisions.
template <int D>
struct Collisions {
  std::vector<int> count;             ///< with other fluid, of each particle
  std::vector<std::uint8_t> at_wall;  ///< 1 where a wall particle is near enough to ask
  Vecs<D> change;                     ///< of the velocity [m/s]
};

/// Perfectly inelastic collision: a pair closer than `distance` that approaches loses its velocity of approach, shared
/// equally between two fluid particles (momentum is kept). Koshizuka & Oka (1996) use such a collision at 0.5 l0. Where
/// both are near the free surface the distance is l0 at least: with p given there, pressure can't keep those particles
/// at their spacing. All pairs act at once, so each is weakened by the number of collisions of its busier partner:
/// energy can only fall. Also finds what is at a wall, for collide_with_walls().
template <int D>
void collide_close_pairs(double distance, double l0, const std::vector<std::uint8_t>& near, const Neighbours<D>& list,
                         State<D>& s, Collisions<D>& buffers) {
  const int size = static_cast<int>(s.size());
  std::vector<int>& count = buffers.count;
  std::vector<std::uint8_t>& at_wall = buffers.at_wall;
  Vecs<D>& change = buffers.change;
  resize_kept(count, s.size());
  resize_kept(at_wall, s.size());
  resize_kept(change, s.size());
  // Calls fluid(j, velocity of approach) for each collision of i, and wall() for each wall particle with r^2 < far.
  const auto each_close = [&](int i, double far, auto fluid, auto wall) {
    const Vec<D> ri = s.position[i];
    for (int j : list[i]) {
      const double r2 = squared_distance<D>(s.position, j, ri);
      if (r2 >= far) continue;
      if (s.kind[j] != Kind::fluid) {
        wall();
        continue;
      }
      const double reach = near[i] && near[j] ? std::max(distance, l0) : distance;
      const Vec<D> rij = s.position[j] - ri;
      const double approach = (s.velocity[j] - s.velocity[i]).dot(rij);
      if (r2 < reach * reach && approach < 0) fluid(j, Vec<D>(approach / r2 * rij));
    }
  };
  const double furthest = std::pow(std::max(distance, l0), 2);
  // Before a square lattice of wall particles the nearest lies at most sqrt(D - 1)/2 l0 aside; a tenth more where bent.
  const double aside = 1.21 * 0.25 * (D - 1) * l0 * l0;
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    count[i] = at_wall[i] = 0;
    if (s.kind[i] != Kind::fluid) continue;
    each_close(
        i, furthest + aside, [&](int, const Vec<D>&) { ++count[i]; }, [&] { at_wall[i] = 1; });
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    change[i].setZero();
    if (s.kind[i] != Kind::fluid || count[i] == 0) continue;
    each_close(
        i, furthest, [&](int j, const Vec<D>& velocity) { change[i] += 0.5 / std::max(count[i], count[j]) * velocity; },
        [] {});
  }
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) s.velocity[i] += change[i];
}

/// The same at walls: liquid closer to one than `distance`, l0 near the free surface, less the l0/2 that wall particles
/// lie behind it loses its velocity against it, and keeps what it has along it. By the distance to the wall itself: its
/// particles stand at an angle to what moves along a curved wall, and push it back and forth. Beside the rim of a
/// baffle nothing is stopped.
/// @param at_wall 1 where a wall particle may be near enough
/// @param nearest gives the tank's wall as seen from a point: its distance, negative inside, and its normal there
template <int D, class Wall>
void collide_with_walls(double distance, double l0, const std::vector<std::uint8_t>& near,
                        const std::vector<std::uint8_t>& at_wall, const Wall& nearest, const Neighbours<D>& list,
                        State<D>& s) {
#pragma omp parallel for schedule(static)
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    if (!at_wall[i]) continue;
    const double reach = (near[i] ? std::max(distance, l0) : distance) - 0.5 * l0;
    const Vec<D>& r = s.position[i];
    Vec<D>& u = s.velocity[i];
    const auto stop = [&](const Vec<D>& normal) { u -= std::max(0.0, u.dot(normal)) * normal; };
    if (const auto wall = nearest(r); wall.distance > -reach) stop(wall.normal);
    if (!s.baffles) continue;
    for (int j : list[i]) {
      if (s.behind[j] < 0) continue;
      const BaffleFace<D>& side = s.baffles->faces()[s.behind[j]];
      const double behind = side.behind(r);
      if (behind <= 0 && -behind < reach && side.holds(side.foot(r))) stop(side.normal_at(r));
    }
  }
}

}  // namespace seiche::solver
