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

}  // namespace

template <int D>
LevelAxes<D>::LevelAxes(const Gravity& gravity)
    : upright_(gravity.is_upright()), turn_(turn_to_level(gravity).topLeftCorner<D, D>()) {}

template <int D>
Bounds<D> LevelAxes<D>::bounds_of(const Shape<D>& tank) const {
  if (upright_) return tank.bounds();
  const SurfaceMesh wall = tank.surface();
  Bounds<D> bounds{Vec<D>::Constant(std::numeric_limits<double>::infinity()),
                   Vec<D>::Constant(-std::numeric_limits<double>::infinity())};
  for (const auto& point : wall.points) {
    const Vec<D> r = (*this)(Eigen::Vector3d(point.data()).head<D>());
    bounds = {bounds.low.cwiseMin(r), bounds.high.cwiseMax(r)};
  }
  return bounds;
}

SurfaceMesh on_level_axes(SurfaceMesh mesh, const Gravity& gravity) {
  const LevelAxes<3> axes(gravity);
  for (auto& point : mesh.points) {
    const Vec<3> turned = axes(Vec<3>(point.data()));
    point = {turned[0], turned[1], turned[2]};
  }
  return mesh;
}

template class LevelAxes<2>;
template class LevelAxes<3>;

}  // namespace seiche::solver
