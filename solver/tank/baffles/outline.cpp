#include "solver/tank/baffles/outline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

Vec<2> left_of(const Vec<2>& way) { return Vec<2>(-way[1], way[0]).normalized(); }

/// Where the line at a distance to the left of the polyline passes its point k.
Vec<2> beside(const std::vector<Vec<2>>& points, std::size_t k, double distance) {
  const Vec<2> before = left_of(points[std::max<std::size_t>(k, 1)] - points[std::max<std::size_t>(k, 1) - 1]);
  const Vec<2> after = k + 1 < points.size() ? left_of(points[k + 1] - points[k]) : before;
  return points[k] + distance * (before + after) / (1 + before.dot(after));
}

void check(const BaffleLine& baffle) {
  const auto& points = baffle.points;
  if (points.size() < 2) throw BadParameters("a baffle has two points at least: give points = [[x, y], [x, y], ...]");
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec<2> way = points[k] - points[k - 1];
    const auto place = fmt::format("({:.6g}, {:.6g}) m", points[k - 1][0], points[k - 1][1]);
    if (!(way.norm() > 0)) throw BadParameters(fmt::format("a baffle has two points one after the other at {}", place));
    if (k < 2) continue;
    // Each side is moved by half the thickness over the tangent of half the angle at the bend.
    const Vec<2> last = points[k - 1] - points[k - 2];
    const double cosine = last.dot(way) / (last.norm() * way.norm());
    const double moved = 0.5 * baffle.thickness * std::sqrt(std::max(0.0, (1 - cosine) / (1 + cosine)));
    if (!(moved < std::min(last.norm(), way.norm())))
      throw BadParameters(
          fmt::format("a baffle {:.6g} m thick bends too sharply at {}: give it longer parts, or less thickness",
                      baffle.thickness, place));
  }
}

}  // namespace

std::vector<Vec<2>> outline_of(const BaffleLine& baffle) {
  check(baffle);
  const auto& points = baffle.points;
  std::vector<Vec<2>> outline;
  if (baffle.thickness == 0) {
    outline = points;
    for (std::size_t k = points.size() - 1; k-- > 1;) outline.push_back(points[k]);
    return outline;
  }
  for (std::size_t k = 0; k < points.size(); ++k) outline.push_back(beside(points, k, -0.5 * baffle.thickness));
  for (std::size_t k = points.size(); k-- > 0;) outline.push_back(beside(points, k, 0.5 * baffle.thickness));
  return outline;
}

std::vector<double> crossings_of(const Vec<2>& a, const Vec<2>& b, const std::vector<Vec<2>>& closed_walk) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < closed_walk.size(); ++k) {
    const Vec<2>& from = closed_walk[k];
    const Vec<2> way = closed_walk[(k + 1) % closed_walk.size()] - from;
    const double before = cross(way, a - from), after = cross(way, b - from);
    if ((before > 0) == (after > 0)) continue;
    const double share = before / (before - after), along = way.dot(a + share * (b - a) - from);
    if (share > 0 && share < 1 && along >= 0 && along <= way.squaredNorm()) shares.push_back(share);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

std::vector<std::string> numbered(const std::vector<std::string>& names) {
  std::vector<std::string> all = names;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (std::count(names.begin(), names.end(), names[k]) > 1) {
      const auto end = names.begin() + static_cast<std::ptrdiff_t>(k) + 1;
      all[k] += fmt::format("_{}", std::count(names.begin(), end, names[k]));
    }
  return all;
}

}  // namespace seiche::solver
