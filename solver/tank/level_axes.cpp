#include "solver/tank/level_axes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace seiche::solver {
namespace {

Eigen::Matrix3d turn_to_level(const Gravity& gravity) {
  if (gravity.is_upright()) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d up = -Eigen::Vector3d(gravity[0], gravity[1], gravity[2]), y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d across = up.cross(y);
  // A tank that stands on its head is turned about z, as in 2-D.
  const Eigen::Vector3d axis = across.isZero(0) ? Eigen::Vector3d::UnitZ() : across.normalized();
  return Eigen::AngleAxisd(std::atan2(across.norm(), up.dot(y)), axis).toRotationMatrix();
}

/// Adds a triangle's parts, cut across its longest side until none is longer than that.
void add_parts(const std::array<int, 3>& triangle, double longest, SurfaceMesh& mesh, SurfaceMesh::Patch& patch) {
  const auto point = [&](std::size_t k) {
    return Eigen::Vector3d(mesh.points[static_cast<std::size_t>(triangle[k % 3])].data());
  };
  std::size_t side = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if ((point(k + 1) - point(k)).norm() > (point(side + 1) - point(side)).norm()) side = k;
  const int from = triangle[side], to = triangle[(side + 1) % 3], opposite = triangle[(side + 2) % 3];
  if ((point(side + 1) - point(side)).norm() <= longest) {
    patch.faces.push_back({from, to, opposite});
    return;
  }
  const Eigen::Vector3d middle = 0.5 * (point(side) + point(side + 1));
  const int added = static_cast<int>(mesh.points.size());
  mesh.points.push_back({middle[0], middle[1], middle[2]});
  add_parts({from, added, opposite}, longest, mesh, patch);
  add_parts({added, to, opposite}, longest, mesh, patch);
}

/// The same surface in triangles whose sides are at most a hundredth of it: a chord of that length leaves a paraboloid
/// that rises by h over the surface by 2e-5 h.
SurfaceMesh finer(const SurfaceMesh& mesh) {
  SurfaceMesh parts;
  parts.points = mesh.points;
  const auto size = mesh.size();
  const double longest = 0.01 * std::hypot(size[0], size[1], size[2]);
  for (const auto& patch : mesh.patches) {
    SurfaceMesh::Patch cut{patch.name, {}};
    for (const std::vector<int>& face : patch.faces)
      for (std::size_t k = 2; k < face.size(); ++k) add_parts({face[0], face[k - 1], face[k]}, longest, parts, cut);
    parts.patches.push_back(std::move(cut));
  }
  return parts;
}

}  // namespace

template <int D>
LevelAxes<D>::LevelAxes(const RelativeEquilibrium& at_rest)
    : upright_(at_rest.gravity.is_upright()),
      straight_(at_rest.spin == 0),
      bend_(straight_ ? 0 : at_rest.spin * at_rest.spin / (2 * at_rest.gravity.size())),
      turn_(turn_to_level(at_rest.gravity).topLeftCorner<D, D>()),
      pivot_(turn_ * Eigen::Vector3d(at_rest.pivot.data()).head<D>()) {}

template <int D>
Bounds<D> LevelAxes<D>::bounds_of(const Shape<D>& tank) const {
  if (upright_ && straight_) return tank.bounds();
  const SurfaceMesh wall = straight_ ? tank.surface() : finer(tank.surface());
  Bounds<D> bounds{Vec<D>::Constant(std::numeric_limits<double>::infinity()),
                   Vec<D>::Constant(-std::numeric_limits<double>::infinity())};
  for (const auto& point : wall.points) {
    const Vec<D> r = (*this)(Eigen::Vector3d(point.data()).head<D>());
    bounds = {bounds.low.cwiseMin(r), bounds.high.cwiseMax(r)};
  }
  return bounds;
}

SurfaceMesh on_level_axes(SurfaceMesh mesh, const RelativeEquilibrium& at_rest) {
  const LevelAxes<3> axes(at_rest);
  if (!axes.straight()) mesh = finer(mesh);
  for (auto& point : mesh.points) {
    const Vec<3> turned = axes(Vec<3>(point.data()));
    point = {turned[0], turned[1], turned[2]};
  }
  return mesh;
}

template class LevelAxes<2>;
template class LevelAxes<3>;

}  // namespace seiche::solver
