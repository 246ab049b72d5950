#include "solver/tank/shapes/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/shapes/path.hpp"

namespace seiche::solver {
namespace {

/// The edge as pieces along each of which the coordinate only grows or only falls.
std::vector<Edge> monotone(const Edge& edge, int axis) {
  if (edge.bulge == 0) return {edge};
  std::vector<double> shares{0, 1};
  for (const double sign : {-1.0, 1.0}) {
    const double share = edge.nearest_share(edge.centre() + sign * edge.radius() * Vec<2>::Unit(axis));
    if (share > 0 && share < 1) shares.push_back(share);
  }
  std::sort(shares.begin(), shares.end());
  std::vector<Edge> pieces;
  for (std::size_t k = 0; k + 1 < shares.size(); ++k) pieces.push_back(piece(edge, shares[k], shares[k + 1]));
  return pieces;
}

/// Where the piece has the value, which lies between those of its ends.
double place_of(const Edge& edge, int axis, double value) {
  const int along = 1 - axis;
  if (edge.bulge == 0) {
    const double share = (value - edge.from[axis]) / (edge.to[axis] - edge.from[axis]);
    return edge.from[along] + share * (edge.to[along] - edge.from[along]);
  }
  const Vec<2> centre = edge.centre();
  const double radius = edge.radius(), off = value - centre[axis];
  const double reach = std::sqrt(std::max(0.0, radius * radius - off * off));
  return edge.point(0.5)[along] > centre[along] ? centre[along] + reach : centre[along] - reach;
}

}  // namespace

std::vector<Crossing> crossings(const Contour& wall, int axis, double value) {
  std::vector<Crossing> all;
  for (const auto& loop : wall.loops())
    for (const Edge& edge : loop)
      for (const Edge& part : monotone(edge, axis))
        if ((part.from[axis] > value) != (part.to[axis] > value))
          all.push_back({place_of(part, axis, value), edge.patch});
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  return all;
}

std::vector<AreaPoint> filled_rows(const Contour& wall, double l0) {
  const Bounds<2> bounds = wall.bounds();
  const double rows = std::max(1.0, std::round(bounds.size()[1] / l0)), height = bounds.size()[1] / rows;
  std::vector<AreaPoint> points;
  double sum = 0;
  for (double row = 0; row < rows; ++row) {
    const double y = bounds.low[1] + (row + 0.5) * height;
    const std::vector<Crossing> ends = crossings(wall, 1, y);
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      const double length = ends[k + 1].at - ends[k].at;
      const double count = std::max(1.0, std::round(length / l0));
      for (double m = 0; m < count; ++m)
        points.push_back({{ends[k].at + (m + 0.5) * length / count, y}, length / count * height});
      sum += length * height;
    }
  }
  for (AreaPoint& point : points) point.area *= wall.area() / sum;
  return points;
}

}  // namespace seiche::solver
