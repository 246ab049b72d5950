#include "solver/tank/edge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

/// To the right of v.
Vec<2> right_of(const Vec<2>& v) { return {v[1], -v[0]}; }

}  // namespace

double Edge::angle() const { return 4 * std::atan(bulge); }

double Edge::radius() const { return (to - from).norm() * (1 + bulge * bulge) / (4 * std::abs(bulge)); }

Vec<2> Edge::centre() const {
  // On the left of the chord's middle if the arc turns left by less than half a circle.
  return 0.5 * (from + to) - (1 - bulge * bulge) / (4 * bulge) * right_of(to - from);
}

double Edge::length() const { return bulge == 0 ? (to - from).norm() : radius() * std::abs(angle()); }

Vec<2> Edge::point(double share) const {
  if (share <= 0) return from;
  if (share >= 1) return to;
  if (bulge == 0) return from + share * (to - from);
  const Vec<2> c = centre();
  return c + Eigen::Rotation2Dd(share * angle()) * (from - c);
}

Vec<2> Edge::normal(double share) const {
  if (bulge == 0) return right_of(to - from).normalized();
  const Vec<2> outwards = (Eigen::Rotation2Dd(share * angle()) * (from - centre())).normalized();
  return bulge > 0 ? outwards : Vec<2>(-outwards);
}

double Edge::nearest_share(const Vec<2>& r) const {
  if (bulge == 0) return std::clamp((r - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
  const Vec<2> c = centre(), start = from - c, at = r - c;
  if (at.isZero()) return 0;
  // How far r lies along the arc, by angle; what is beyond its ends goes to the nearer one.
  const double turn = bulge > 0 ? 1 : -1, whole = std::abs(angle());
  double along = std::atan2(turn * cross(start, at), start.dot(at));
  if (along < 0) along += 2 * std::numbers::pi;
  if (along <= whole) return along / whole;
  return along - whole < 2 * std::numbers::pi - along ? 1 : 0;
}

}  // namespace seiche::solver
