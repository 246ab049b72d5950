#pragma once
#include "solver/gravity.hpp"
#include "solver/surface_mesh.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// Axes about the tank's origin whose y points up, against gravity: those of the tank, turned by the least angle that
/// does it. In an upright tank, and without gravity, they are the tank's own.
template <int D>
class LevelAxes {
 public:
  explicit LevelAxes(const Gravity& gravity = {});

  /// The same place or direction in these axes.
  Vec<D> operator()(const Vec<D>& in_tank) const { return upright_ ? in_tank : Vec<D>(turn_ * in_tank); }

  Vec<D> in_tank(const Vec<D>& in_these) const { return upright_ ? in_these : Vec<D>(turn_.transpose() * in_these); }

  /// In the tank's axes.
  Vec<D> up() const { return turn_.row(1); }

  /// Height of a place above the tank's origin [m].
  double height(const Vec<D>& in_tank) const { return upright_ ? in_tank[1] : turn_.row(1).dot(in_tank); }

  /// Of the tank along these axes [m].
  Bounds<D> bounds_of(const Shape<D>& tank) const;

 private:
  bool upright_;
  Eigen::Matrix<double, D, D> turn_ = Eigen::Matrix<double, D, D>::Identity();
};

/// The mesh in those axes.
SurfaceMesh on_level_axes(SurfaceMesh mesh, const Gravity& gravity);

}  // namespace seiche::solver
