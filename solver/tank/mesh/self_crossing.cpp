#include "solver/tank/mesh/self_crossing.hpp"

#include <algorithm>

#include "solver/tank/box_tree.hpp"
#include "solver/tank/mesh/edges.hpp"

namespace seiche::solver {
namespace {

bool share_a_corner(const Triangles& mesh, int t, const MeshEdge& edge) {
  const auto& corners = mesh.corners[t];
  return std::any_of(corners.begin(), corners.end(), [&](int at) { return at == edge.low || at == edge.high; });
}

/// How an edge goes through a triangle.
SelfCrossing crossing(const Triangles& mesh, const MeshEdge& edge, int t) {
  const Vec<3>&from = mesh.points[edge.low], &to = mesh.points[edge.high];
  const Vec<3> area = mesh.area(t), normal = area.normalized();
  const double before = (from - mesh.corner(t, 0)).dot(normal), after = (to - mesh.corner(t, 0)).dot(normal);
  if (before * after >= 0) return {};
  const Vec<3> at = from + before / (before - after) * (to - from);
  for (int k = 0; k < 3; ++k) {
    const Vec<3>&a = mesh.corner(t, k), &b = mesh.corner(t, (k + 1) % 3);
    if (cross(b - a, at - a).dot(area) < -1e-9 * area.squaredNorm()) return {};
  }
  return {std::min(std::abs(before), std::abs(after)), at};
}

}  // namespace

SelfCrossing self_crossing(const Triangles& mesh) {
  std::vector<Bounds<3>> boxes;
  for (int t = 0; t < mesh.count(); ++t) boxes.push_back(mesh.box(t));
  const BoxTree<3> tree(boxes);
  const std::vector<MeshEdge> edges = edges_of(mesh);
  std::vector<SelfCrossing> deepest(edges.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const MeshEdge& edge = edges[e];
    const Vec<3>&from = mesh.points[edge.low], &to = mesh.points[edge.high];
    const Vec<3> low = from.cwiseMin(to), high = from.cwiseMax(to);
    const double reach = 0.25 * (to - from).squaredNorm();
    tree.search(
        0.5 * (from + to),
        [&](int t) {
          const bool apart = (boxes[t].low.array() > high.array()).any() || (boxes[t].high.array() < low.array()).any();
          if (apart || share_a_corner(mesh, t, edge)) return reach;
          if (const SelfCrossing one = crossing(mesh, edge, t); one.depth > deepest[e].depth) deepest[e] = one;
          return reach;
        },
        reach);
  }
  SelfCrossing all;
  for (const SelfCrossing& one : deepest)
    if (one.depth > all.depth) all = one;
  return all;
}

}  // namespace seiche::solver
