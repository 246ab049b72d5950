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

/// Whether two faces are one smooth surface that doesn't turn away from the camera between them.
bool joined(const Vector3d& a, const Vector3d& b, const Vector3d& to_camera) {
  return a.dot(b) > std::cos(std::numbers::pi / 6) && (a.dot(to_camera) > 0) == (b.dot(to_camera) > 0);
}

/// Whether the faces that meet at an edge go on smoothly, in pairs: both sides of a plate do.
bool all_joined(std::vector<Vector3d> normals, const Vector3d& to_camera) {
  while (!normals.empty()) {
    const Vector3d last = normals.back();
    normals.pop_back();
    const auto other = std::find_if(normals.begin(), normals.end(),
                                    [&](const Vector3d& normal) { return joined(last, normal, to_camera); });
    if (other == normals.end()) return false;
    normals.erase(other);
  }
  return true;
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
  for (const auto& [key, edge] : edges)
    if (!all_joined(edge.normals, to_camera)) shown.push_back({edge.from, edge.to});
  return shown;
}

}  // namespace seiche::render
