#include "render/picture/tank_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace seiche::render {
namespace {

using Eigen::Vector3d;

/// The mean normal of a polygon, as long as twice its area (Newell).
Vector3d normal_of(const std::vector<Vector3d>& corners) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) sum += corners[k].cross(corners[(k + 1) % corners.size()]);
  return sum;
}

}  // namespace

std::vector<std::array<Vector3d, 2>> tank_edges(const SurfaceMesh& tank, const Vector3d& to_camera) {
  // Faces may have corners of their own: those within a millionth of the tank's size are one.
  const auto size = tank.size();
  const double grid = 1e-6 * std::max({size[0], size[1], size[2]});
  std::map<std::array<long, 3>, int> places;
  const auto place_of = [&](const Vector3d& r) {
    const std::array<long, 3> key{std::lround(r[0] / grid), std::lround(r[1] / grid), std::lround(r[2] / grid)};
    return places.emplace(key, static_cast<int>(places.size())).first->second;
  };
  struct Edge {
    Vector3d from, to;
    std::vector<Vector3d> normals;
  };
  std::map<std::array<int, 2>, Edge> edges;
  for (const SurfaceMesh::Patch& patch : tank.patches)
    for (const auto& face : patch.faces) {
      std::vector<Vector3d> corners;
      for (const int corner : face) corners.emplace_back(tank.points[static_cast<std::size_t>(corner)].data());
      const Vector3d normal = normal_of(corners).normalized();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector3d &from = corners[k], &to = corners[(k + 1) % corners.size()];
        const int a = place_of(from), b = place_of(to);
        if (a == b) continue;
        edges.try_emplace({std::min(a, b), std::max(a, b)}, Edge{from, to, {}}).first->second.normals.push_back(normal);
      }
    }
  std::vector<std::array<Vector3d, 2>> shown;
  for (const auto& [key, edge] : edges) {
    const auto& n = edge.normals;
    const bool joint = n.size() == 2 && n[0].dot(n[1]) > std::cos(std::numbers::pi / 6) &&
                       (n[0].dot(to_camera) > 0) == (n[1].dot(to_camera) > 0);
    if (!joint) shown.push_back({edge.from, edge.to});
  }
  return shown;
}

}  // namespace seiche::render
