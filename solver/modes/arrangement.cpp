#include "solver/modes/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/tank/edge.hpp"

namespace seiche::solver::modes {
namespace {

using Line = std::array<Vec<2>, 2>;

/// Adds the share of a at which b meets it, and those of the ends of b that lie on it.
void add_meetings(const Line& a, const Line& b, double tolerance, std::vector<double>& shares) {
  const Vec<2> way = a[1] - a[0], other = b[1] - b[0];
  const double length = way.norm();
  for (const Vec<2>& end : b) {
    const double share = (end - a[0]).dot(way) / (length * length);
    if (share > 0 && share < 1 && std::abs(cross(way, end - a[0])) <= tolerance * length) shares.push_back(share);
  }
  const double sine = cross(way, other);
  if (std::abs(sine) <= 1e-12 * length * other.norm()) return;
  const double share = cross(b[0] - a[0], other) / sine, of_other = cross(b[0] - a[0], way) / sine;
  if (share > 0 && share < 1 && of_other > 0 && of_other < 1) shares.push_back(share);
}

struct Points {
  std::vector<Vec<2>> all;
  double tolerance;

  int number(const Vec<2>& r) {
    const auto near =
        std::find_if(all.begin(), all.end(), [&](const Vec<2>& p) { return (p - r).norm() <= 2 * tolerance; });
    const auto number = static_cast<int>(near - all.begin());
    if (near == all.end()) all.push_back(r);
    return number;
  }
};

}  // namespace

Arrangement arranged(const std::vector<Line>& lines, double tolerance) {
  Points points{{}, tolerance};
  for (const Line& line : lines)
    for (const Vec<2>& end : line) points.number(end);
  std::vector<std::vector<Way>> ways;
  for (const Line& a : lines) {
    std::vector<double> shares{0, 1};
    const Vec<2> low = a[0].cwiseMin(a[1]).array() - tolerance, high = a[0].cwiseMax(a[1]).array() + tolerance;
    for (const Line& b : lines)
      if (&a != &b && (b[0].cwiseMax(b[1]).array() >= low.array()).all() &&
          (b[0].cwiseMin(b[1]).array() <= high.array()).all())
        add_meetings(a, b, tolerance, shares);
    std::sort(shares.begin(), shares.end());
    auto& own = ways.emplace_back();
    int last = points.number(a[0]);
    for (const double share : shares) {
      const int next = points.number(a[0] + share * (a[1] - a[0]));
      if (next != last) own.push_back({last, next});
      last = next;
    }
  }
  return {std::move(points.all), std::move(ways)};
}

Polygons walks(const std::vector<Vec<2>>& points, std::set<Way> ways) {
  const auto at = [&](int k) -> const Vec<2>& { return points[static_cast<std::size_t>(k)]; };
  Polygons polygons;
  while (!ways.empty()) {
    auto& polygon = polygons.emplace_back();
    auto way = ways.begin();
    while (way != ways.end()) {
      const auto [from, here] = *way;
      ways.erase(way);
      polygon.push_back(at(from));
      const Vec<2> back = at(from) - at(here);
      double least = 3 * std::numbers::pi;
      way = ways.end();
      for (auto next = ways.lower_bound({here, -1}); next != ways.end() && next->first == here; ++next) {
        const Vec<2> out = at(next->second) - at(here);
        double angle = -std::atan2(cross(back, out), back.dot(out));  // clockwise from the way back
        if (angle <= 0 || next->second == from) angle += 2 * std::numbers::pi;
        if (angle < least) {
          least = angle;
          way = next;
        }
      }
    }
  }
  return polygons;
}

}  // namespace seiche::solver::modes
