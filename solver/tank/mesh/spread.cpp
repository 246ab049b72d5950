#include "solver/tank/mesh/spread.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/tank/mesh/point_grid.hpp"

namespace seiche::solver {
namespace {

// Of l0. Points thrown at random that are no nearer than that settle to one on each l0^2.
constexpr double thrown_gap = 0.79;
constexpr double side_of_piece = 0.25;
constexpr double mitre_gap = 0.7;
constexpr double grid_cell = 1.3;
/// How far a piece may be from its point.
constexpr double farthest = 1.25;
constexpr double neighbourhood = 2;
constexpr double least_volume = 0.2;
constexpr int rounds = 20;

bool has_room(const PointGrid& grid, const Vec<3>& r, double gap) { return grid.nearest(r, gap) < 0; }

/// In an order that is random but always the same.
std::vector<int> shuffled(int count) {
  std::vector<int> order(count);
  for (int k = 0; k < count; ++k) order[k] = k;
  std::mt19937 random(1);
  for (int k = count - 1; k > 0; --k) std::swap(order[k], order[random() % (k + 1U)]);
  return order;
}

void throw_points(const LayerSurface& surface, const std::vector<ShellPiece>& pieces, double l0, PointGrid& grid) {
  std::mt19937 random(2);
  const auto anywhere = [&] { return l0 * side_of_piece * (static_cast<double>(random()) / random.max() - 0.5); };
  for (const int k : shuffled(static_cast<int>(pieces.size()))) {
    const ShellPiece& piece = pieces[k];
    const double off = std::abs(piece.depth - surface.depth()) + side_of_piece * l0;
    if (off > 0.4 * l0) continue;
    const double x = anywhere(), y = anywhere(), z = anywhere();
    const Vec<3> at = piece.at + Vec<3>(x, y, z);
    if (!has_room(grid, at, thrown_gap * l0 - off)) continue;
    if (const auto placed = surface.place(at); placed && has_room(grid, *placed, thrown_gap * l0)) grid.add(*placed);
  }
}

/// The points near each point, itself the first.
std::vector<std::vector<int>> neighbours_of(const Vecs<3>& points, double radius) {
  PointGrid grid(radius);
  for (const Vec<3>& r : points) grid.add(r);
  std::vector<std::vector<int>> all(points.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    all[i].push_back(i);
    grid.near(points[i], [&](int j, double squared) {
      if (j != i && squared < radius * radius) all[i].push_back(j);
    });
  }
  return all;
}

/// The point nearest to each piece, looked for near the one that it had.
void give_pieces(const std::vector<ShellPiece>& pieces, const Vecs<3>& points, double l0, std::vector<int>& owner) {
  const auto near = neighbours_of(points, neighbourhood * l0);
#pragma omp parallel for schedule(static)
  for (int k = 0; k < static_cast<int>(pieces.size()); ++k) {
    if (owner[k] < 0) continue;
    double least = std::numeric_limits<double>::infinity();
    const int before = owner[k];
    for (const int i : near[before])
      if (const double squared = (points[i] - pieces[k].at).squaredNorm(); squared < least)
        least = squared, owner[k] = i;
  }
}

std::vector<int> first_owners(const std::vector<ShellPiece>& pieces, const PointGrid& grid, double l0) {
  std::vector<int> owner(pieces.size());
#pragma omp parallel for schedule(static)
  for (int k = 0; k < static_cast<int>(pieces.size()); ++k) owner[k] = grid.nearest(pieces[k].at, farthest * l0);
  return owner;
}

/// Moves the points but the first few to the middles of their pieces.
void settle(const LayerSurface& surface, const std::vector<ShellPiece>& pieces, const std::vector<int>& owner,
            int fixed, Vecs<3>& points) {
  Vecs<3> sum(points.size(), Vec<3>::Zero());
  Scalars volume(points.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (owner[k] < 0) continue;
    sum[owner[k]] += pieces[k].volume * pieces[k].at;
    volume[owner[k]] += pieces[k].volume;
  }
#pragma omp parallel for schedule(dynamic, 64)
  for (int i = fixed; i < static_cast<int>(points.size()); ++i)
    if (volume[i] > 0)
      if (const auto placed = surface.place(sum[i] / volume[i])) points[i] = *placed;
}

}  // namespace

std::vector<SpreadPoint> spread_points(const LayerSurface& surface, const std::vector<ShellPiece>& pieces, double l0,
                                       std::vector<ShellPiece>& left) {
  PointGrid grid(grid_cell * l0);
  for (const Vec<3>& r : surface.mitre_points(l0))
    if (has_room(grid, r, mitre_gap * l0)) grid.add(r);
  const int fixed = static_cast<int>(grid.points().size());
  throw_points(surface, pieces, l0, grid);
  std::vector<int> owner = first_owners(pieces, grid, l0);
  Vecs<3> points = grid.points();
  for (int round = 0; round < rounds; ++round) {
    settle(surface, pieces, owner, fixed, points);
    give_pieces(pieces, points, l0, owner);
  }
  // Points that got next to nothing make way.
  Scalars volume(points.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (owner[k] >= 0) volume[owner[k]] += pieces[k].volume;
  PointGrid kept(grid_cell * l0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (volume[i] > least_volume) kept.add(points[i]);
  owner = first_owners(pieces, kept, l0);
  std::vector<SpreadPoint> result;
  for (const Vec<3>& r : kept.points()) result.push_back({r});
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (owner[k] >= 0)
      result[owner[k]].volume += pieces[k].volume;
    else
      left.push_back(pieces[k]);
  }
  return result;
}

}  // namespace seiche::solver
