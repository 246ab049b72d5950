#include "solver/tank/baffles/sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

using std::numbers::pi;

/// A place along an axis, the share of l0 that it stands for, and how far beyond the end it is.
struct Step {
  double at, share, beyond;
};

/// Over a length about 0 in equal steps of about l0, and beyond its ends in steps of l0.
std::vector<Step> steps_over(double half, double l0, double reach) {
  const int count = std::max(1, static_cast<int>(std::lround(2 * half / l0)));
  const double step = 2 * half / count;
  std::vector<Step> steps;
  for (int k = 0; half > 0 && k < count; ++k) steps.push_back({-half + (k + 0.5) * step, step / l0, 0});
  for (double beyond = 0.5 * l0; beyond < reach; beyond += l0)
    for (const double side : {-1.0, 1.0}) steps.push_back({side * (half + beyond), 1, beyond});
  return steps;
}

}  // namespace

std::vector<BaffleFace<3>> sides_of(const FlatBaffle& longer, const Rims& rims) {
  const Vec<3> up = longer.normal(), &u = longer.u, &v = longer.v;
  const double half = 0.5 * longer.thickness;
  const bool is_plate = longer.thickness == 0;
  const FlatRegion& region = longer.region;
  std::vector<BaffleFace<3>> sides;
  for (const double side : {1.0, -1.0})
    sides.push_back({FlatSide(longer.placed(Vec<2>::Zero(), side * half), u, v, -side * up, region, is_plate)});
  if (is_plate) return sides;
  if (region.is_disc()) {
    if (!rims.outer[0].on_wall) sides.push_back({RoundSide{longer.origin, up, region.round, half, false}});
  } else {
    for (int k = 0; k < 4; ++k) {
      if (rims.outer[static_cast<std::size_t>(k)].on_wall) continue;
      const int across = k / 2;
      const double sign = k % 2 == 0 ? -1 : 1;
      Vec<2> middle = Vec<2>::Zero();
      middle[across] = sign * region.half[across];
      const Vec<3> out = sign * (across == 0 ? u : v), along = across == 0 ? v : u;
      sides.push_back(
          {FlatSide(longer.placed(middle), along, up, -out, {{region.half[1 - across], half}, 0, {}}, false)});
    }
  }
  for (const auto& hole : region.holes)
    sides.push_back({RoundSide{longer.placed(hole.centre), up, hole.radius, half, true}});
  return sides;
}

void SidePoints::add(const BaffleFace<3>& face, int number, std::vector<WallPoint<3>>& points) const {
  if (const auto* flat = std::get_if<FlatSide>(&face.side))
    add_flat(*flat, number, points);
  else
    add_round(std::get<RoundSide>(face.side), number, points);
}

template <class At, class Normal>
void SidePoints::add_column(const Vec<3>& foot, double beyond, int number, At at, Normal normal,
                            std::vector<WallPoint<3>>& points) const {
  const double past_wall = tank.nearest(foot).distance;
  beyond = std::max(beyond, past_wall);
  for (int k = 0; k < layers; ++k) {
    const double depth = (k + 0.5) * l0;
    if (std::hypot(beyond, depth) >= reach) continue;
    const auto [r, weight] = at(depth);
    if (!(weight > 0)) continue;
    Vec<3> facing = normal(r);
    if (past_wall > 1e-9 * l0)
      if (const Nearest<3> wall = tank.nearest(r); wall.distance > 0) facing = wall.normal;
    points.push_back({r, facing, weight, beyond > 1e-9 * l0 ? std::max(k, 1) : k, patch, {}, number});
  }
}

void SidePoints::add_flat(const FlatSide& side, int number, std::vector<WallPoint<3>>& points) const {
  const FlatRegion& region = side.region;
  const double extent = region.round + reach;
  const std::vector<Step> across = steps_over(region.half[0], l0, extent),
                          along = steps_over(region.half[1], l0, extent);
  for (const Step& y : along)
    for (const Step& x : across) {
      const double beyond = std::max(0.0, region.rim({x.at, y.at}).distance);
      if (beyond >= reach) continue;
      const Vec<3> foot = side.placed({x.at, y.at});
      add_column(
          foot, beyond, number,
          [&](double depth) { return std::pair<Vec<3>, double>(foot + depth * side.normal, x.share * y.share); },
          [&](const Vec<3>& r) { return side.normal_at(r); }, points);
    }
}

void SidePoints::add_round(const RoundSide& side, int number, std::vector<WallPoint<3>>& points) const {
  const Vec<3> u = side.axis.unitOrthogonal();
  const Vec<3> v(side.axis[1] * u[2] - side.axis[2] * u[1], side.axis[2] * u[0] - side.axis[0] * u[2],
                 side.axis[0] * u[1] - side.axis[1] * u[0]);
  // Behind a hole's wall they spread.
  const double mean = side.radius + (side.of_hole ? 0.5 * reach : 0);
  const int count = std::max(3, static_cast<int>(std::lround(2 * pi * mean / l0)));
  bool odd = false;
  for (const Step& step : steps_over(side.half, l0, reach)) {
    for (int k = 0; k < count; ++k) {
      const double angle = (2 * k + odd) * pi / count;
      const Vec<3> out = std::cos(angle) * u + std::sin(angle) * v, middle = side.origin + step.at * side.axis;
      add_column(
          middle + side.radius * out, step.beyond, number,
          [&](double depth) {
            const double radius = side.radius + (side.of_hole ? depth : -depth);
            return std::pair<Vec<3>, double>(middle + radius * out, step.share * 2 * pi * radius / (count * l0));
          },
          [&](const Vec<3>& r) { return side.normal_at(r); }, points);
    }
    odd = !odd;
  }
}

}  // namespace seiche::solver
