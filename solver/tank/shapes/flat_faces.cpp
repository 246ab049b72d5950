#include "solver/tank/shapes/flat_faces.hpp"

#include <algorithm>

namespace seiche::solver {
namespace {

using Loop = std::vector<Contour::Corner>;

bool is_convex(const Loop& loop) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec<2>&a = loop[k].position, &b = loop[(k + 1) % loop.size()].position,
          &c = loop[(k + 2) % loop.size()].position;
    if (cross(b - a, c - b) < -1e-12 * (b - a).norm() * (c - b).norm()) return false;
  }
  return true;
}

/// Where a side of the loops that spans a strip meets its lower and upper edge.
struct Side {
  double low, high;
};

std::vector<Side> sides_of(const std::vector<Loop>& loops, double low, double high) {
  std::vector<Side> sides;
  for (const Loop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec<2>&a = loop[k].position, &b = loop[(k + 1) % loop.size()].position;
      if (std::min(a[1], b[1]) > low || std::max(a[1], b[1]) < high || a[1] == b[1]) continue;
      const auto at = [&](double y) { return a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]); };
      sides.push_back({at(low), at(high)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low + a.high < b.low + b.high; });
  return sides;
}

}  // namespace

std::vector<Vecs<2>> flat_faces(const std::vector<Loop>& loops) {
  std::vector<Vecs<2>> faces;
  if (loops.size() == 1 && is_convex(loops[0])) {
    faces.emplace_back();
    for (const auto& corner : loops[0]) faces[0].push_back(corner.position);
    return faces;
  }
  std::vector<double> heights;
  for (const Loop& loop : loops)
    for (const auto& corner : loop) heights.push_back(corner.position[1]);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    const double low = heights[k], high = heights[k + 1];
    if (high - low <= 1e-12 * (heights.back() - heights.front())) continue;  // what rounding parts
    const std::vector<Side> sides = sides_of(loops, low, high);
    for (std::size_t m = 0; m + 1 < sides.size(); m += 2)
      faces.push_back({{sides[m].low, low}, {sides[m + 1].low, low}, {sides[m + 1].high, high}, {sides[m].high, high}});
  }
  return faces;
}

}  // namespace seiche::solver
