#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "solver/particles/face.hpp"

namespace seiche::solver {

/// A flat side of a thin wall within the tank, as liquid meets it: a part of a plane, the normal into the thin wall.
template <int D>
struct BaffleFace;

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

  /// The point of it that is nearest to r.
  Vec<2> nearest(const Vec<2>& r) const {
    const Vec<2> way = to - from;
    return from + std::clamp(way.dot(r - from) / way.squaredNorm(), 0.0, 1.0) * way;
  }

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
};

/// In 3-D the part that loops go round in its plane, within an odd number of them.
template <>
struct BaffleFace<3> : Face<3> {
  Vec<3> origin, u, v;                     ///< of the plane: a point [m], and unit vectors along it
  std::vector<std::vector<Vec<2>>> loops;  ///< (u, v) of their corners [m]
  bool of_plate;                           ///< the other side is in the same place

  /// @param along_u, along_v unit vectors square to each other; the normal is along_u x along_v
  BaffleFace(const Vec<3>& at, const Vec<3>& along_u, const Vec<3>& along_v, std::vector<std::vector<Vec<2>>> round,
             bool plate)
      : origin(at), u(along_u), v(along_v), loops(std::move(round)), of_plate(plate) {
    normal = u.cross(v);
    offset = normal.dot(at);
  }

  Vec<2> in_plane(const Vec<3>& r) const { return {u.dot(r - origin), v.dot(r - origin)}; }

  Vec<3> nearest(const Vec<3>& r) const {
    const Vec<3> foot = r - behind(r) * normal;
    return holds(foot) ? foot : nearest_of_rim(r);
  }

  double distance_to_rim(const Vec<3>& r) const {
    return of_plate ? (nearest_of_rim(r) - r).norm() : std::numeric_limits<double>::infinity();
  }

  Vec<3> nearest_of_rim(const Vec<3>& r) const {
    const Vec<2> at = in_plane(r);
    Vec<2> best = loops.front().front();
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec<2> from = loop[k], way = loop[(k + 1) % loop.size()] - from;
        const Vec<2> point = from + std::clamp(way.dot(at - from) / way.squaredNorm(), 0.0, 1.0) * way;
        if ((point - at).squaredNorm() < (best - at).squaredNorm()) best = point;
      }
    return origin + best[0] * u + best[1] * v;
  }

  bool holds(const Vec<3>& r) const {
    const Vec<2> at = in_plane(r);
    bool inside = false;
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec<2>&a = loop[k], &b = loop[(k + 1) % loop.size()];
        if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
          inside = !inside;
      }
    return inside;
  }
};

/// The sides of the thin walls within a tank, which hide what lies behind them: two particles of liquid are neighbours
/// only if the way from one to the other enters none, and a particle that stands for the solid behind a side is one
/// only if that is the first which the way to it enters. So each side of a wall thinner than the reach of a pair has a
/// solid of its own, also where the other side's liquid is.
template <int D>
class Baffles {
 public:
  explicit Baffles(std::vector<BaffleFace<D>> faces) : faces_(std::move(faces)) {}

  const std::vector<BaffleFace<D>>& faces() const { return faces_; }

  /// The first face that the way enters, of several in one place the one that comes first here; -1 if it enters none.
  int entered(const Vec<D>& from, const Vec<D>& to) const {
    double first = std::numeric_limits<double>::infinity();
    int found = -1;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const double before = -faces_[k].behind(from), after = faces_[k].behind(to);
      if (before < 0 || after <= 0) continue;
      const double share = before / (before + after);
      if (!(share < first - 1e-9) || !faces_[k].holds(from + share * (to - from))) continue;
      first = share;
      found = static_cast<int>(k);
    }
    return found;
  }

  /// Whether two particles are neighbours.
  /// @param behind_a, behind_b the faces whose solid they stand for, -1 of liquid and of what lies behind the tank's
  ///        wall
  bool sees(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const {
    if (behind_a < 0 && behind_b < 0) return entered(a, b) < 0 && entered(b, a) < 0;
    if (behind_a >= 0 && behind_b >= 0 && behind_a != behind_b && !face_each_other(a, behind_a, b, behind_b))
      return false;
    return behind_a == behind_b || (behind_b >= 0 && entered(a, b) == behind_b) ||
           (behind_a >= 0 && entered(b, a) == behind_a);
  }

  /// Whether liquid at one point sees liquid at another.
  bool sees(const Vec<D>& a, const Vec<D>& b) const { return sees(a, -1, b, -1); }

  /// Whether the rim of a plate is nearer to r than that [m].
  bool is_at_rim(const Vec<D>& r, double distance) const {
    return std::any_of(faces_.begin(), faces_.end(),
                       [&](const auto& face) { return face.distance_to_rim(r) < distance; });
  }

  /// Whether any face is nearer to r than that [m].
  bool is_near(const Vec<D>& r, double distance) const {
    return std::any_of(faces_.begin(), faces_.end(),
                       [&](const auto& face) { return (face.nearest(r) - r).squaredNorm() < distance * distance; });
  }

 private:
  /// Whether liquid can stand before both sides, as in a corner between them: each particle's foot is before the
  /// other's side.
  bool face_each_other(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const {
    const BaffleFace<D>&first = faces_[behind_a], &second = faces_[behind_b];
    return second.behind(a - first.behind(a) * first.normal) < 0 &&
           first.behind(b - second.behind(b) * second.normal) < 0;
  }

  std::vector<BaffleFace<D>> faces_;
};

}  // namespace seiche::solver
