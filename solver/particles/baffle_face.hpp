#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "solver/particles/face.hpp"
#include "solver/particles/flat_region.hpp"

namespace seiche::solver {

/// A side of a thin wall within the tank, as liquid meets it, the normal into the thin wall.
template <int D>
struct BaffleFace;

/// Share of the way at which it enters a flat side, as `BaffleFace::entry`.
template <class Side, class Point>
double entry_of(const Side& side, const Point& from, const Point& to, double limit) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double before = -side.behind(from), after = side.behind(to);
  if (before < 0 || after <= 0) return never;
  const double share = before / (before + after);
  return share < limit && side.holds(from + share * (to - from)) ? share : never;
}

/// In 2-D the part from one point to another, the thin wall on the left of the way.
template <>
struct BaffleFace<2> : Face<2> {
  Vec<2> from, to;              ///< [m]
  bool rim_at_from, rim_at_to;  ///< a plate ends there, in the liquid

  BaffleFace(const Vec<2>& a, const Vec<2>& b, bool rim_at_a, bool rim_at_b)
      : from(a), to(b), rim_at_from(rim_at_a), rim_at_to(rim_at_b) {
    const Vec<2> way = (b - a).normalized();
    normal = {-way[1], way[0]};
    offset = normal.dot(a);
  }

  Vec<2> normal_at(const Vec<2>&) const { return normal; }

  /// The point of its line that r is before or behind.
  Vec<2> foot(const Vec<2>& r) const { return r - behind(r) * normal; }

  /// The point of it that is nearest to r.
  Vec<2> nearest(const Vec<2>& r) const {
    const Vec<2> way = to - from;
    return from + std::clamp(way.dot(r - from) / way.squaredNorm(), 0.0, 1.0) * way;
  }

  bool is_near(const Vec<2>& r, double distance) const { return (nearest(r) - r).squaredNorm() < distance * distance; }

  /// Whether a plate's rim is nearer to r than that [m].
  bool is_at_rim(const Vec<2>& r, double distance) const { return distance_to_rim(r) < distance; }

  double distance_to_rim(const Vec<2>& r) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    return std::min(rim_at_from ? (r - from).norm() : none, rim_at_to ? (r - to).norm() : none);
  }

  /// Whether a point of its plane is on it: no rim is, and sides that meet overlap, both by a millionth, so that both
  /// sides of a plate agree, and nothing slips through between two of them.
  bool holds(const Vec<2>& r) const {
    const Vec<2> way = to - from;
    const double share = way.dot(r - from) / way.squaredNorm();
    return share > (rim_at_from ? 1e-6 : -1e-6) && share < (rim_at_to ? 1 - 1e-6 : 1 + 1e-6);
  }

  /// Share of the way at which it enters; infinite if it doesn't, or not before `limit`.
  double entry(const Vec<2>& begin, const Vec<2>& end, double limit) const {
    return entry_of(*this, begin, end, limit);
  }
};

/// In 3-D a flat side: a region of a plane.
struct FlatSide : Face<3> {
  Vec<3> origin, u, v;  ///< of the region: a point [m], and unit vectors along it
  FlatRegion region;
  bool of_plate;  ///< the other side is in the same place

  /// @param along_u, along_v unit vectors square to each other
  /// @param into the thin wall: along_u x along_v, or the other way
  FlatSide(const Vec<3>& at, const Vec<3>& along_u, const Vec<3>& along_v, const Vec<3>& into, FlatRegion within,
           bool plate)
      : Face<3>{into, into.dot(at)}, origin(at), u(along_u), v(along_v), region(std::move(within)), of_plate(plate) {}

  Vec<2> in_plane(const Vec<3>& r) const { return {u.dot(r - origin), v.dot(r - origin)}; }
  Vec<3> placed(const Vec<2>& r) const { return origin + r[0] * u + r[1] * v; }
  Vec<3> normal_at(const Vec<3>&) const { return normal; }
  Vec<3> foot(const Vec<3>& r) const { return r - behind(r) * normal; }

  Vec<3> nearest(const Vec<3>& r) const {
    const Vec<2> at = in_plane(r);
    const FlatRegion::Rim rim = region.rim(at);
    return placed(rim.distance < 0 ? at : rim.foot);
  }

  bool is_at_rim(const Vec<3>& r, double distance) const {
    return of_plate && std::abs(behind(r)) < distance &&
           (placed(region.rim(in_plane(r)).foot) - r).squaredNorm() < distance * distance;
  }

  /// As in 2-D: no rim of a plate is on it, and sides that meet overlap.
  bool holds(const Vec<3>& r) const {
    const double slack = 1e-6 * (region.half.maxCoeff() + region.round);
    return region.rim(in_plane(r)).distance < (of_plate ? -slack : slack);
  }

  double entry(const Vec<3>& from, const Vec<3>& to, double limit) const { return entry_of(*this, from, to, limit); }
};

/// In 3-D the rim of a thick disc, or of a hole through one: a part of a circular cylinder.
struct RoundSide {
  Vec<3> origin, axis;  ///< its middle [m], and a unit vector
  double radius, half;  ///< [m]; half of its length along the axis
  bool of_hole;         ///< the liquid is within it

  double behind(const Vec<3>& r) const {
    const double beyond = off_axis(r).norm() - radius;
    return of_hole ? beyond : -beyond;
  }
  Vec<3> normal_at(const Vec<3>& r) const { return of_hole ? outwards(r) : Vec<3>(-outwards(r)); }
  Vec<3> foot(const Vec<3>& r) const { return origin + along(r) * axis + radius * outwards(r); }
  Vec<3> nearest(const Vec<3>& r) const {
    return origin + std::clamp(along(r), -half, half) * axis + radius * outwards(r);
  }
  bool is_at_rim(const Vec<3>&, double) const { return false; }
  bool holds(const Vec<3>& r) const { return std::abs(along(r)) < (1 + 1e-6) * half; }

  /// Where the way leaves the liquid's side: of a hole the farther crossing, else the nearer one.
  double entry(const Vec<3>& from, const Vec<3>& to, double limit) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    const Vec<3> begin = off_axis(from), way = off_axis(to) - begin;
    const double squared = way.squaredNorm(), mean = begin.dot(way), off = begin.squaredNorm() - radius * radius;
    const double root = mean * mean - squared * off;
    if (squared == 0 || root < 0) return never;
    const double share = (-mean + (of_hole ? 1 : -1) * std::sqrt(root)) / squared;
    return share >= 0 && share < 1 && share < limit && holds(from + share * (to - from)) ? share : never;
  }

 private:
  double along(const Vec<3>& r) const { return axis.dot(r - origin); }
  Vec<3> off_axis(const Vec<3>& r) const { return r - origin - along(r) * axis; }
  Vec<3> outwards(const Vec<3>& r) const {
    const Vec<3> off = off_axis(r);
    const double distance = off.norm();
    return distance > 0 ? Vec<3>(off / distance) : Vec<3>(axis.unitOrthogonal());
  }
};

template <>
struct BaffleFace<3> {
  std::variant<FlatSide, RoundSide> side;

  double behind(const Vec<3>& r) const {
    return std::visit([&](const auto& form) { return form.behind(r); }, side);
  }
  Vec<3> normal_at(const Vec<3>& r) const {
    return std::visit([&](const auto& form) { return form.normal_at(r); }, side);
  }
  Vec<3> foot(const Vec<3>& r) const {
    return std::visit([&](const auto& form) { return form.foot(r); }, side);
  }
  Vec<3> nearest(const Vec<3>& r) const {
    return std::visit([&](const auto& form) { return form.nearest(r); }, side);
  }
  bool holds(const Vec<3>& r) const {
    return std::visit([&](const auto& form) { return form.holds(r); }, side);
  }
  bool is_near(const Vec<3>& r, double distance) const {
    return std::abs(behind(r)) < distance && (nearest(r) - r).squaredNorm() < distance * distance;
  }
  bool is_at_rim(const Vec<3>& r, double distance) const {
    return std::visit([&](const auto& form) { return form.is_at_rim(r, distance); }, side);
  }
  double entry(const Vec<3>& from, const Vec<3>& to, double limit) const {
    return std::visit([&](const auto& form) { return form.entry(from, to, limit); }, side);
  }
};

}  // namespace seiche::solver
