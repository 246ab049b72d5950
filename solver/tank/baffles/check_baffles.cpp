#include "solver/tank/baffles/check_baffles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/tank/baffles/baffled.hpp"
#include "solver/tank/baffles/check_gap.hpp"

namespace seiche::solver {
namespace {

/// Points along a line, half a spacing apart or less.
Vecs<2> points_along(const std::vector<Vec<2>>& line, double l0) {
  Vecs<2> points;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * (line[k + 1] - line[k]).norm() / l0)));
    for (int m = 0; m < parts; ++m) points.emplace_back(line[k] + (line[k + 1] - line[k]) * m / parts);
  }
  points.push_back(line.back());
  return points;
}

double distance_to(const std::vector<Vec<2>>& line, const Vec<2>& r) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    least = std::min(least, (BaffleFace<2>(line[k], line[k + 1], false, false).nearest(r) - r).norm());
  return least;
}

template <class Distance>
Scalars along(const Vecs<2>& points, const Distance& distance) {
  Scalars all;
  for (const Vec<2>& r : points) all.push_back(distance(r));
  return all;
}

}  // namespace

void check_baffles(const Shape<2>& tank, const std::vector<BaffleLine>& baffles, double l0) {
  const double touching = Baffled::touching * l0;
  for (std::size_t k = 0; k < baffles.size(); ++k) {
    const BaffleLine& baffle = baffles[k];
    outline_of(baffle);  // throws
    double length = 0;
    for (std::size_t m = 1; m < baffle.points.size(); ++m) length += (baffle.points[m] - baffle.points[m - 1]).norm();
    const Vec<2>& first = baffle.points.front();
    if (length < l0 * (1 - 1e-6))
      throw BadParameters(
          fmt::format("the baffle from ({:.6g}, {:.6g}) m is {:.4g} m long, {:.3g} spacings; a run needs 1: take a "
                      "smaller particles.spacing, or leave the baffle out",
                      first[0], first[1], length, length / l0));
    const Vecs<2> points = points_along(baffle.points, l0);
    // Half of its thickness lies between its line and its side.
    const double half = 0.5 * baffle.thickness;
    const bool inside =
        std::any_of(points.begin(), points.end(), [&](const Vec<2>& r) { return tank.nearest(r).distance < 0; });
    if (!inside) continue;  // it lies outside the tank, which is said elsewhere
    const auto ends = [&](const Vec<2>& r) { return r == points.front() || r == points.back(); };
    const auto to_wall = [&](const Vec<2>& r) { return -tank.nearest(r).distance - (ends(r) ? 0 : half); };
    check_gap<2>(points, along(points, to_wall), l0, touching, false, "the baffle", "the tank's wall");
    for (std::size_t other = 0; other < baffles.size(); ++other) {
      if (other == k) continue;
      const auto to_other = [&](const Vec<2>& r) {
        return distance_to(baffles[other].points, r) - 0.5 * baffles[other].thickness - (ends(r) ? 0 : half);
      };
      check_gap<2>(points, along(points, to_other), l0, touching, false, "the baffle", "another baffle");
    }
  }
}

}  // namespace seiche::solver
