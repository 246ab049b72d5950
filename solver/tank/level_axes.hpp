#pragma once
#include <array>
#include <cmath>
#include <utility>

#include "solver/gravity.hpp"
#include "solver/surface_mesh.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// Under what liquid is at rest relative to the tank: a gravity, the inertial force of a steady acceleration included,
/// and a steady rotation about its line through the pivot. The pressure is
///   p = rho g (level - y + spin^2/(2 g) |r_h - pivot_h|^2),
/// y against the gravity and r_h square to it: surfaces of equal pressure are level, with rotation paraboloids.
struct RelativeEquilibrium {
  Gravity gravity;                ///< [m/s^2], in the tank's axes
  double spin = 0;                ///< [rad/s]; of 2-D none
  std::array<double, 3> pivot{};  ///< [m]

  bool operator==(const RelativeEquilibrium&) const = default;
};

/// Axes about the tank's origin whose y points up, against gravity: those of the tank, turned by the least angle that
/// does it. In an upright tank, and without gravity, they are the tank's own. Of liquid that turns steadily y is taken
/// from its paraboloids, y -= spin^2/(2 g) |r_h - pivot_h|^2: what is level is a plane y in these axes, and volumes are
/// what they are in the tank.
template <int D>
class LevelAxes {
 public:
  explicit LevelAxes(const RelativeEquilibrium& at_rest);
  explicit LevelAxes(const Gravity& gravity = {}) : LevelAxes(RelativeEquilibrium{gravity}) {}

  /// The same place in these axes; without spin also a direction.
  Vec<D> operator()(const Vec<D>& in_tank) const {
    if (straight_) return upright_ ? in_tank : Vec<D>(turn_ * in_tank);
    Vec<D> r = turn_ * in_tank;
    r[1] -= rise(r);
    return r;
  }

  Vec<D> in_tank(const Vec<D>& in_these) const {
    if (straight_) return upright_ ? in_these : Vec<D>(turn_.transpose() * in_these);
    Vec<D> r = in_these;
    r[1] += rise(r);
    return turn_.transpose() * r;
  }

  /// Against gravity, in the tank's axes.
  Vec<D> up() const { return turn_.row(1); }

  /// y of a place [m]: without spin its height above the tank's origin.
  double height(const Vec<D>& in_tank) const {
    if (!straight_) return (*this)(in_tank)[1];
    return upright_ ? in_tank[1] : turn_.row(1).dot(in_tank);
  }

  /// Of a square or cubic cell along these axes, about a place in them [m].
  double half_diagonal(const Vec<D>& in_these, double side) const {
    if (straight_) return 0.5 * std::sqrt(D) * side;
    const double slope = 2 * bend_ * across(in_these - pivot_).template lpNorm<1>();
    return 0.5 * side * std::sqrt(D - 1 + (1 + slope) * (1 + slope));
  }

  /// Of the tank along these axes [m].
  Bounds<D> bounds_of(const Shape<D>& tank) const;

  bool straight() const { return straight_; }

 private:
  static Vec<D> across(Vec<D> r) {
    r[1] = 0;
    return r;
  }
  double rise(const Vec<D>& r) const { return bend_ * across(r - pivot_).squaredNorm(); }

  bool upright_;
  bool straight_;
  double bend_;  ///< spin^2/(2 g) [1/m]
  Eigen::Matrix<double, D, D> turn_ = Eigen::Matrix<double, D, D>::Identity();
  Vec<D> pivot_;  ///< turned [m]
};

/// The mesh in those axes; of liquid that turns with faces small enough to follow its paraboloids.
SurfaceMesh on_level_axes(SurfaceMesh mesh, const RelativeEquilibrium& at_rest);

inline SurfaceMesh on_level_axes(SurfaceMesh mesh, const Gravity& gravity) {
  return on_level_axes(std::move(mesh), RelativeEquilibrium{gravity});
}

}  // namespace seiche::solver
