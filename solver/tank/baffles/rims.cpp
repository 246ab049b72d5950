#include "solver/tank/baffles/rims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

using std::numbers::pi;

Vecs<3> on_circle(const FlatBaffle& baffle, const Vec<2>& centre, double radius, double l0) {
  const int count = std::max(16, static_cast<int>(std::ceil(4 * pi * radius / l0)));
  Vecs<3> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * pi * k / count;
    points.push_back(baffle.placed(centre + radius * Vec<2>(std::cos(angle), std::sin(angle))));
  }
  return points;
}

/// Along the side of a rectangle at -u, +u, -v or +v.
Vecs<3> on_side(const FlatBaffle& baffle, int side, double l0) {
  const int across = side / 2, along = 1 - across;
  Vec<2> from = baffle.region.half;
  from[across] *= side % 2 == 0 ? -1 : 1;
  Vec<2> to = from;
  from[along] = -from[along];
  const int parts = std::max(4, static_cast<int>(std::ceil(2 * (to - from).norm() / l0)));
  Vecs<3> points;
  for (int k = 0; k <= parts; ++k) points.push_back(baffle.placed(from + (to - from) * k / parts));
  return points;
}

}  // namespace

Rims rims_of(const FlatBaffle& baffle, const Shape<3>& tank, double l0, double touching) {
  const auto rim = [&](Vecs<3> points, bool closed) {
    const bool on_wall = std::all_of(points.begin(), points.end(),
                                     [&](const Vec<3>& r) { return tank.nearest(r).distance > -touching; });
    return Rim{std::move(points), closed, on_wall};
  };
  Rims rims;
  if (baffle.region.is_disc())
    rims.outer.push_back(rim(on_circle(baffle, Vec<2>::Zero(), baffle.region.round, l0), true));
  else
    for (int side = 0; side < 4; ++side) rims.outer.push_back(rim(on_side(baffle, side, l0), false));
  for (const auto& hole : baffle.region.holes)
    rims.holes.push_back(rim(on_circle(baffle, hole.centre, hole.radius, l0), true));
  return rims;
}

FlatBaffle prolonged(const FlatBaffle& baffle, const Rims& rims, double by) {
  FlatBaffle longer = baffle;
  FlatRegion& region = longer.region;
  Vec<2> moved = Vec<2>::Zero();
  if (region.is_disc()) {
    if (rims.outer[0].on_wall) region.round += by;
  } else {
    for (int side = 0; side < 4; ++side) {
      if (!rims.outer[static_cast<std::size_t>(side)].on_wall) continue;
      region.half[side / 2] += 0.5 * by;
      moved[side / 2] += side % 2 == 0 ? -0.5 * by : 0.5 * by;
    }
  }
  longer.origin = baffle.placed(moved);
  for (std::size_t k = 0; k < region.holes.size(); ++k) {
    region.holes[k].centre -= moved;
    if (rims.holes[k].on_wall) region.holes[k].radius -= by;
  }
  std::erase_if(region.holes, [](const auto& hole) { return !(hole.radius > 0); });
  return longer;
}

bool is_in_tank(const FlatBaffle& baffle, const Shape<3>& tank, double l0) {
  const FlatRegion& region = baffle.region;
  const Vec<2> size = region.half + Vec<2>::Constant(region.round);
  const Bounds<3> bounds = tank.bounds();
  // A tank that it goes far beyond is looked for where the tank is.
  const Vec<2> middle = baffle.in_plane(0.5 * (bounds.low + bounds.high));
  const double extent = 0.5 * bounds.size().norm();
  const Vec<2> low = (-size).cwiseMax(middle - Vec<2>::Constant(extent)),
               high = size.cwiseMin(middle + Vec<2>::Constant(extent));
  if ((low.array() > high.array()).any()) return false;
  Eigen::Vector2i parts;
  for (int axis = 0; axis < 2; ++axis)
    parts[axis] = std::max(4, static_cast<int>(std::ceil(2 * (high[axis] - low[axis]) / l0)));
  for (int i = 0; i < parts[0]; ++i)
    for (int k = 0; k < parts[1]; ++k) {
      const Vec<2> share((i + 0.5) / parts[0], (k + 0.5) / parts[1]);
      const Vec<2> at = low + share.cwiseProduct(high - low);
      if (region.rim(at).distance < 0 && tank.nearest(baffle.placed(at)).distance < 0) return true;
    }
  return false;
}

}  // namespace seiche::solver
