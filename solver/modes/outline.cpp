#include "solver/modes/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/errors.hpp"
#include "solver/modes/level_cut.hpp"

namespace seiche::solver::modes {
namespace {

/// Products of two whole numbers up to this, and their differences, are exact.
constexpr double cells = 1 << 25;

struct Grid {
  Vec<2> origin;
  double unit;

  Vec<2> snapped(const Vec<2>& r) const { return ((r - origin) / unit).array().round(); }
};

Grid grid_over(const Polygons& section) {
  Vec<2> low = Vec<2>::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& polygon : section)
    for (const Vec<2>& r : polygon) {
      if (!r.allFinite())
        throw BadParameters(
            fmt::format("first frequencies: the section has a point at ({}, {}); give numbers", r[0], r[1]));
      low = low.cwiseMin(r);
      high = high.cwiseMax(r);
    }
  const double size = (high - low).maxCoeff();
  if (!(size > 0) || !std::isfinite(size))
    throw BadParameters("first frequencies: the section has no size; give three points at least");
  return {low, size / cells};
}

double signed_area(const Loop& loop) {
  double sum = 0;
  for (std::size_t k = 2; k < loop.size(); ++k) sum += turn(loop[0].at, loop[k - 1].at, loop[k].at);
  return 0.5 * sum;
}

bool is_inside(const Loop& loop, const Vec<2>& r) {
  bool inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec<2>&a = loop[k].at, &b = loop[(k + 1) % loop.size()].at;
    if ((a[1] > r[1]) != (b[1] > r[1]) && turn(a, b, r) * (b[1] - a[1]) > 0) inside = !inside;
  }
  return inside;
}

/// The smallest that is round the loop, or the end.
std::vector<Outline>::iterator around(std::vector<Outline>& bodies, const Loop& loop) {
  auto best = bodies.end();
  for (auto body = bodies.begin(); body != bodies.end(); ++body)
    if (is_inside(body->outer, 0.5 * (loop[0].at + loop[1].at)) &&
        (best == bodies.end() || signed_area(body->outer) < signed_area(best->outer)))
      best = body;
  return best;
}

/// A plate of two corners gets one on each of its sides, which tells them apart.
Loop with_sides(Loop loop) {
  if (loop.size() != 2) return loop;
  const Corner middle{(0.5 * (loop[0].at + loop[1].at)).array().round(), false};
  return {loop[0], middle, loop[1], middle};
}

bool has_surface(const Outline& body) {
  return std::any_of(body.outer.begin(), body.outer.end(), [](const Corner& corner) { return corner.surface; });
}

}  // namespace

std::vector<Outline> liquid_below(double level, const Polygons& section) {
  const Grid grid = grid_over(section);
  double lowest = cells, highest = 0;
  std::vector<std::vector<Vec<2>>> snapped;
  for (const auto& polygon : section) {
    auto& points = snapped.emplace_back();
    for (const Vec<2>& r : polygon) {
      const Vec<2> at = grid.snapped(r);
      if (points.empty() || at != points.back()) points.push_back(at);
      lowest = std::min(lowest, at[1]);
      highest = std::max(highest, at[1]);
    }
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  }
  const double height = std::round((level - grid.origin[1]) / grid.unit);
  const double bottom = grid.origin[1] + grid.unit * lowest, top = grid.origin[1] + grid.unit * highest;
  if (!(height > lowest))
    throw BadParameters(
        fmt::format("first frequencies: the level of {:.6g} m leaves no liquid in a tank whose lowest point is at "
                    "{:.6g} m; fill it higher",
                    level, bottom));
  if (height > highest)
    throw BadParameters(fmt::format(
        "first frequencies: the level of {:.6g} m is above the tank's top at {:.6g} m; fill it lower", level, top));

  const std::vector<Loop> loops = loops_below(height, snapped);
  std::vector<Outline> bodies;
  for (const Loop& loop : loops)
    if (signed_area(loop) > 0) bodies.push_back({loop, {}, grid.origin, grid.unit});
  for (const Loop& loop : loops)
    if (!(signed_area(loop) > 0)) {
      const auto body = around(bodies, loop);
      if (body != bodies.end()) body->holes.push_back(with_sides(loop));
    }
  std::erase_if(bodies, [](const Outline& body) { return !has_surface(body); });
  if (bodies.empty())
    throw BadParameters(fmt::format(
        "first frequencies: the liquid has no free surface at the level of {:.6g} m; fill the tank less", level));
  return bodies;
}

}  // namespace seiche::solver::modes
