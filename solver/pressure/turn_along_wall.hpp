#pragma once
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// Walls that turn by more than 30 degrees over a spacing meet in a corner.
inline constexpr double cosine_of_corner = 0.866;

/// Acceleration of liquid at r [m] that moves at u [m/s] along a wall that bends [m/s^2]: u.n = 0 holds it to
///   -(u.(u.grad) n) n,
/// n the wall's normal, the difference of it over l0 along u taken. Zero in a corner, where liquid comes to rest.
template <int D>
Vec<D> turn_along_wall(const Shape<D>& tank, const Vec<D>& r, const Vec<D>& u, double l0) {
  const double speed = u.norm();
  if (speed == 0) return Vec<D>::Zero();
  const Vec<D> way = 0.5 * l0 / speed * u;
  const Vec<D> before = tank.nearest(r - way).normal, after = tank.nearest(r + way).normal;
  if (before.dot(after) < cosine_of_corner) return Vec<D>::Zero();
  return -speed / l0 * u.dot(after - before) * (before + after).normalized();
}

}  // namespace seiche::solver
