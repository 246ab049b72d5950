#include "solver/tank/shapes/slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/tank/shapes/crossings.hpp"
#include "solver/tank/shapes/mirrored.hpp"
#include "solver/tank/shapes/path.hpp"

namespace seiche::solver {
namespace {

using Edges = std::vector<Edge>;

/// Adds a curve from `from` to `to` as chords that lie within the tolerance of it. @param at the curve, by share
template <class At>
void add_chords(const At& at, double from, double to, int patch, double tolerance, Edges& chords, int depth = 0) {
  const Vec<2> a = at(from), b = at(to), chord = b - a;
  const auto off = [&](double share) {
    const Vec<2> r = at(from + share * (to - from)) - a;
    const double along = std::clamp(r.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    return (r - along * chord).norm();
  };
  const bool fine = std::max({off(0.25), off(0.5), off(0.75)}) < tolerance;
  if (depth > 30 || fine) {
    if (chord.norm() > 1e-9 * tolerance) chords.push_back({a, b, 0, patch});
    return;
  }
  const double middle = 0.5 * (from + to);
  add_chords(at, from, middle, patch, tolerance, chords, depth + 1);
  add_chords(at, middle, to, patch, tolerance, chords, depth + 1);
}

/// Loops of the half section u >= 0 in a plane at an offset from the axis: u^2 = radius^2 - offset^2.
std::vector<Edges> half_beside_axis(const Contour& half, double offset) {
  const double size = half.bounds().size().maxCoeff(), tolerance = 1e-6 * size;
  std::vector<Edges> all;
  for (const Edges& loop : half.loops()) {
    Edges parts;
    for (const Edge& edge : loop)
      add_kept(
          edge, [&](const Vec<2>& r) { return r[0] >= offset; }, 1e-3 * size, parts);
    for (const Path& path : joined(parts, 1e-9 * size)) {
      Edges chords;
      for (const Edge& edge : path.edges) {
        const auto at = [&](double share) {
          const Vec<2> r = edge.point(share);
          return Vec<2>(std::sqrt(std::max(0.0, (r[0] - offset) * (r[0] + offset))), r[1]);
        };
        add_chords(at, 0, 1, edge.patch, tolerance, chords);
      }
      for (std::size_t k = 1; k < chords.size(); ++k) chords[k].from = chords[k - 1].to;
      if (path.closed) {
        chords.front().from = chords.back().to;
      } else {
        Vec<2>&first = chords.front().from, &last = chords.back().to;
        first[0] = last[0] = 0;
        chords.push_back({last, first, 0, 0});
      }
      all.push_back(std::move(chords));
    }
  }
  return all;
}

/// A circle, from its lowest point.
Edges circle(const Vec<2>& centre, double radius, int patch) {
  const Vec<2> low = centre - Vec<2>(0, radius), high = centre + Vec<2>(0, radius);
  return {{low, high, 1, patch}, {high, low, 1, patch}};
}

}  // namespace

void check_met(const Bounds<3>& bounds, const SectionPlane& plane) {
  const int axis = static_cast<int>(plane.axis);
  if (plane.at > bounds.low[axis] && plane.at < bounds.high[axis]) return;
  throw BadParameters(fmt::format("the section {} = {:.6g} m misses the tank, which goes from {} = {:.6g} to {:.6g} m",
                                  name(plane.axis), plane.at, name(plane.axis), bounds.low[axis], bounds.high[axis]));
}

Section section_of(std::vector<Edges> loops, const std::vector<std::string>& names) {
  std::vector<std::string> used;
  std::vector<int> number(names.size(), -1);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto has = [&](const Edge& edge) { return edge.patch == static_cast<int>(k); };
    const bool met = std::any_of(loops.begin(), loops.end(),
                                 [&](const Edges& loop) { return std::any_of(loop.begin(), loop.end(), has); });
    if (!met) continue;
    number[k] = static_cast<int>(used.size());
    used.push_back(names[k]);
  }
  for (Edges& loop : loops)
    for (Edge& edge : loop) edge.patch = number[static_cast<std::size_t>(edge.patch)];
  return Section(Contour(std::move(loops)), std::move(used));
}

Section slice(const Extruded& tank, const SectionPlane& plane) {
  check_met(tank.bounds(), plane);
  if (plane.axis == Axis::z) return tank.section();
  // A rectangle for each piece of the line x = at.
  std::vector<std::string> names = tank.section().patches();
  const int near = static_cast<int>(names.size());
  names.insert(names.end(), {"near", "far"});
  const std::vector<Crossing> ends = crossings(tank.section().wall(), 0, plane.at);
  const double left = tank.z_low(), right = tank.z_high();
  std::vector<Edges> loops;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    const double low = ends[k].at, high = ends[k + 1].at;
    loops.push_back({{{left, low}, {right, low}, 0, ends[k].patch},
                     {{right, low}, {right, high}, 0, near + 1},
                     {{right, high}, {left, high}, 0, ends[k + 1].patch},
                     {{left, high}, {left, low}, 0, near}});
  }
  return section_of(std::move(loops), names);
}

Section slice(const Revolved& tank, const SectionPlane& plane) {
  check_met(tank.bounds(), plane);
  const int axis = static_cast<int>(plane.axis), across = 2 - axis;  // the run's x
  const double offset = std::abs(plane.at - tank.origin()[axis]);
  const Vec<2> origin(tank.origin()[across], tank.origin()[1]);
  std::vector<Edges> loops;
  if (tank.axis() == axis) {
    const std::vector<Crossing> ends = crossings(tank.half(), 1, plane.at - tank.origin()[axis]);
    for (const Crossing& end : ends)
      if (end.at > 1e-9 * tank.half().bounds().size().maxCoeff()) loops.push_back(circle(origin, end.at, end.patch));
    return section_of(std::move(loops), tank.patches());
  }
  if (offset <= 1e-9 * tank.half().bounds().size().maxCoeff())
    loops = tank.whole().loops();
  else
    loops = mirrored(Contour(half_beside_axis(tank.half(), offset))).loops();
  for (Edges& loop : loops)
    for (Edge& edge : loop) {
      if (tank.axis() != 1) {
        // (u, height) to (height, u), which turns left into right.
        edge.from.reverseInPlace();
        edge.to.reverseInPlace();
        edge.bulge = -edge.bulge;
      }
      edge.from += origin;
      edge.to += origin;
    }
  return section_of(std::move(loops), tank.patches());
}

}  // namespace seiche::solver
