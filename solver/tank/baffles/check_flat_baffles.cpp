#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/tank/baffles/baffled_body.hpp"
#include "solver/tank/baffles/check_baffles.hpp"
#include "solver/tank/baffles/check_gap.hpp"

namespace seiche::solver {
namespace {

std::string place(const Vec<3>& r) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", r[0], r[1], r[2]); }

/// Throws for a part that is less than so many spacings wide.
void check_width(const FlatBaffle& baffle, const Vec<3>& at, const std::string& part, double width, double needed,
                 double l0) {
  if (width >= needed * l0 * (1 - 1e-6)) return;
  throw BadParameters(fmt::format(
      "the {} at {} {} {:.4g} m wide, {:.3g} spacings; a run needs {:g}: take particles.spacing = {:.4g} or less, or "
      "leave it out",
      baffle.name, place(at), part, width, width / l0, needed, width / needed));
}

void check_widths(const FlatBaffle& baffle, double l0) {
  const FlatRegion& region = baffle.region;
  const double least = 2 * (region.half.minCoeff() + region.round);
  check_width(baffle, baffle.origin, "is", least, 1, l0);
  for (const auto& hole : region.holes) {
    const Vec<3> at = baffle.placed(hole.centre);
    check_width(baffle, at, "has a hole that is", 2 * hole.radius, 2, l0);
    const double left = -FlatRegion{region.half, region.round, {}}.rim(hole.centre).distance - hole.radius;
    check_width(baffle, at, "leaves beside its hole a strip that is", left, 1, l0);
  }
}

/// Gaps along the rims to the tank's wall and to other baffles.
void check_gaps(const Shape<3>& tank, const std::vector<FlatBaffle>& baffles, std::size_t k, double l0) {
  const FlatBaffle& baffle = baffles[k];
  const double touching = BaffledBody::touching * l0, half = 0.5 * baffle.thickness;
  const Rims rims = rims_of(baffle, tank, l0, touching);
  const auto check = [&](const Rim& rim) {
    const auto gaps = [&](const auto& distance) {
      Scalars all;
      for (const Vec<3>& r : rim.points) all.push_back(distance(r));
      return all;
    };
    // Half of the thickness lies between the rim and what is above or below it.
    const auto to_wall = [&](const Vec<3>& r) {
      const Nearest<3> wall = tank.nearest(r);
      return -wall.distance - half * std::abs(wall.normal.dot(baffle.normal()));
    };
    check_gap<3>(rim.points, gaps(to_wall), l0, touching, rim.closed, "the " + baffle.name, "the tank's wall");
    for (std::size_t other = 0; other < baffles.size(); ++other) {
      if (other == k) continue;
      // What lies beyond the tank's wall is no gap.
      const auto to_other = [&](const Vec<3>& r) {
        const Nearest<3> there = baffles[other].nearest(r);
        const bool in_tank = tank.nearest(r).distance < -touching && tank.nearest(there.foot).distance < -touching;
        return in_tank ? there.distance - half * std::abs(there.normal.dot(baffle.normal())) : 0;
      };
      check_gap<3>(rim.points, gaps(to_other), l0, touching, rim.closed, "the " + baffle.name,
                   "another " + baffles[other].name);
    }
  };
  for (const Rim& rim : rims.outer)
    if (!rim.on_wall) check(rim);
  for (const Rim& rim : rims.holes)
    if (!rim.on_wall) check(rim);
}

}  // namespace

void check_baffles(const Shape<3>& tank, const std::vector<FlatBaffle>& baffles, double l0) {
  for (std::size_t k = 0; k < baffles.size(); ++k) {
    check_widths(baffles[k], l0);
    check_gaps(tank, baffles, k, l0);
  }
}

}  // namespace seiche::solver
