#include "solver/tank/mesh/slivers.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "solver/tank/box_tree.hpp"
#include "solver/tank/mesh/edges.hpp"

namespace seiche::solver {
namespace {

double side_length(const Triangles& mesh, int triangle, int k) {
  return (mesh.corner(triangle, (k + 1) % 3) - mesh.corner(triangle, k)).norm();
}

int longest_side(const Triangles& mesh, int triangle) {
  int longest = 0;
  for (const int k : {1, 2})
    if (side_length(mesh, triangle, k) > side_length(mesh, triangle, longest)) longest = k;
  return longest;
}

bool is_sliver(const Triangles& mesh, int triangle, double height) {
  return 2 * mesh.area(triangle).norm() < height * side_length(mesh, triangle, longest_side(mesh, triangle));
}

/// Cuts a triangle in two at a point of one of its sides.
void cut(Triangles& mesh, const Side& side, int point) {
  auto& corners = mesh.corners[side.triangle];
  std::array<int, 3> other = corners;
  other[side.k] = point;
  corners[(side.k + 1) % 3] = point;
  mesh.add(other, mesh.patch[side.triangle]);
}

void erase(Triangles& mesh, const std::vector<bool>& out) {
  Triangles kept;
  kept.points = std::move(mesh.points);
  for (int t = 0; t < mesh.count(); ++t)
    if (t >= static_cast<int>(out.size()) || !out[t]) kept.add(mesh.corners[t], mesh.patch[t]);
  mesh = std::move(kept);
}

/// Those that don't touch each other. Returns how many it took out.
int take_out_some(Triangles& mesh, double height) {
  std::vector<int> slivers;
  for (int t = 0; t < mesh.count(); ++t)
    if (is_sliver(mesh, t, height)) slivers.push_back(t);
  if (slivers.empty()) return 0;
  std::map<std::pair<int, int>, std::vector<Side>> others;
  for (const int t : slivers) {
    const Side side{t, longest_side(mesh, t)};
    others[std::minmax({begin_of(mesh, side), end_of(mesh, side)})];
  }
  for (const MeshEdge& edge : edges_of(mesh))
    if (const auto at = others.find({edge.low, edge.high}); at != others.end()) at->second = edge.sides;
  std::vector<bool> touched(mesh.count()), out(mesh.count());
  int count = 0;
  for (const int t : slivers) {
    if (touched[t]) continue;
    const Side side{t, longest_side(mesh, t)};
    const auto& sides = others[std::minmax({begin_of(mesh, side), end_of(mesh, side)})];
    if (std::any_of(sides.begin(), sides.end(), [&](const Side& one) { return touched[one.triangle]; })) continue;
    const int third = mesh.corners[t][(side.k + 2) % 3];
    for (const Side& one : sides) {
      touched[one.triangle] = true;
      const auto& corners = mesh.corners[one.triangle];
      if (one.triangle == t) continue;
      if (std::find(corners.begin(), corners.end(), third) != corners.end())
        out[one.triangle] = true;  // the other side of the same sliver
      else
        cut(mesh, one, third);
    }
    out[t] = true;
    ++count;
  }
  erase(mesh, out);
  return count;
}

/// Cuts each triangle at one side at most, as its others have other numbers then.
int cut_once(Triangles& mesh, double tolerance) {
  std::vector<int> ends;
  std::vector<Side> open;
  for (const MeshEdge& edge : edges_of(mesh))
    if (edge.sides.size() == 1) {
      open.push_back(edge.sides[0]);
      ends.insert(ends.end(), {edge.low, edge.high});
    }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Bounds<3>> places;
  for (const int end : ends) places.push_back({mesh.points[end], mesh.points[end]});
  const BoxTree<3> tree(places);
  std::vector<bool> touched(mesh.count());
  int cuts = 0;
  for (const Side& side : open) {
    if (touched[side.triangle]) continue;
    const Vec<3> a = mesh.points[begin_of(mesh, side)], way = mesh.points[end_of(mesh, side)] - a;
    const double length = way.norm(), half = 0.5 * length + tolerance;
    std::vector<std::pair<double, int>> on_side;
    tree.search(a + 0.5 * way, [&](int item) {
      const Vec<3> off = mesh.points[ends[item]] - a;
      const double along = off.dot(way) / length;
      const bool inside = along > tolerance && along < length - tolerance;
      if (inside && (off - along / length * way).norm() < tolerance) on_side.emplace_back(along, ends[item]);
      return half * half;
    });
    // From the far end, so that what is left of the triangle keeps the beginning of its side.
    std::sort(on_side.rbegin(), on_side.rend());
    for (const auto& on : on_side) cut(mesh, side, on.second);
    touched[side.triangle] = !on_side.empty();
    cuts += static_cast<int>(on_side.size());
  }
  return cuts;
}

}  // namespace

int take_out_slivers(Triangles& mesh, double height) {
  int count = 0;
  // Each pass takes out one at least; a cut may leave another, smaller one.
  for (int pass = 0; pass < 100; ++pass) {
    const int some = take_out_some(mesh, height);
    if (some == 0) break;
    count += some;
  }
  // What is left is one that keeps coming back; without it, there is a hole of no width.
  std::vector<bool> out(mesh.count());
  for (int t = 0; t < mesh.count(); ++t) out[t] = is_sliver(mesh, t, height);
  erase(mesh, out);
  return count;
}

int cut_at_points_on_sides(Triangles& mesh, double tolerance) {
  int count = 0;
  for (int pass = 0, cuts = -1; cuts != 0 && pass < 100; ++pass) count += cuts = cut_once(mesh, tolerance);
  return count;
}

}  // namespace seiche::solver
