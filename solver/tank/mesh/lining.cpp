#include "solver/tank/mesh/lining.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/mesh/point_grid.hpp"
#include "solver/tank/mesh/spread.hpp"

namespace seiche::solver {
namespace {

/// The edges of the solid: creases with the liquid on more than 180 degrees.
class SolidEdges {
 public:
  explicit SolidEdges(const MeshSurface& surface) : points_(&surface.mesh().points) {
    std::vector<Bounds<3>> boxes;
    for (const Crease& crease : surface.creases().all()) {
      if (crease.turn > 0) continue;
      edges_.push_back(crease);
      const Vec<3>&a = (*points_)[crease.low], &b = (*points_)[crease.high];
      boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
    }
    tree_ = BoxTree<3>(boxes);
  }

  /// Their faces within reach of r. Of faces that are one curved wall the nearest alone.
  std::vector<Face<3>> faces(const Vec<3>& r, double reach) const {
    std::vector<std::pair<double, int>> near;
    tree_.search(
        r,
        [&](int k) {
          if (const double distance = (nearest_on(k, r) - r).norm(); distance < reach) near.emplace_back(distance, k);
          return reach * reach;
        },
        reach * reach);
    std::sort(near.begin(), near.end());
    std::vector<Face<3>> faces;
    for (const auto& [distance, k] : near)
      for (const Vec<3>& normal : edges_[k].normals) {
        const Vec<3> at = nearest_on(k, r);
        const bool known = std::any_of(faces.begin(), faces.end(), [&](const Face<3>& face) {
          return face.normal.dot(normal) > std::cos(least_turn) && std::abs(face.behind(at)) < 0.1 * reach;
        });
        if (!known) faces.push_back({normal, normal.dot(at)});
      }
    return faces;
  }

 private:
  Vec<3> nearest_on(int k, const Vec<3>& r) const {
    const Vec<3>& a = (*points_)[edges_[k].low];
    const Vec<3> way = (*points_)[edges_[k].high] - a;
    return a + std::clamp((r - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }

  const Vecs<3>* points_;
  std::vector<Crease> edges_;
  BoxTree<3> tree_;
};

/// As `WallPoint` has it.
Vec<3> normal_behind(const MeshSurface& surface, const Vec<3>& r, const Foot& foot) {
  const Creases& creases = surface.creases();
  if (!creases.is_corner(foot)) return creases.smooth_normal(foot);
  const Vec<3> off = r - foot.at;
  for (const Vec<3>& normal : creases.normals_at(foot))
    if (normal.dot(off) > (1 - 1e-9) * off.norm()) return normal;
  return Vec<3>::Zero();
}

}  // namespace

std::vector<WallPoint<3>> lining_of(const MeshSurface& surface, int layers, double l0, double reach) {
  const SolidEdges edges(surface);
  const auto shell = shell_of(surface, layers, l0);
  std::vector<WallPoint<3>> lining;
  PointGrid all(2 * l0);
  for (int layer = 0; layer < layers; ++layer) {
    const LayerSurface at(surface, (layer + 0.5) * l0);
    std::vector<ShellPiece> left;
    for (const SpreadPoint& point : spread_points(at, shell[layer], l0, left)) {
      const Foot foot = surface.foot(point.at);
      lining.push_back({point.at, normal_behind(surface, point.at, foot), point.volume, layer,
                        surface.mesh().patch[foot.triangle], edges.faces(point.at, reach)});
      all.add(point.at);
    }
    for (const ShellPiece& piece : left)
      if (const int k = all.nearest(piece.at, 2 * l0); k >= 0) lining[k].weight += piece.volume;
  }
  return lining;
}

}  // namespace seiche::solver
