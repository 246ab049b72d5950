#include "solver/tank/baffles/flat_baffle.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

constexpr double round_off = 1e-6;

Vec<3> vec(const std::array<double, 3>& r) { return Vec<3>(r.data()); }

std::string place(const Vec<3>& r) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", r[0], r[1], r[2]); }

/// Puts holes into a baffle.
void cut(const std::vector<std::array<double, 4>>& holes, FlatBaffle& baffle) {
  const FlatRegion whole = baffle.region;
  const double size = whole.half.maxCoeff() + whole.round, least = -round_off * size;
  for (const auto& [x, y, z, radius] : holes) {
    const Vec<3> centre(x, y, z);
    if (!(radius > 0))
      throw BadParameters(fmt::format("a hole of a baffle at {} has the radius {:.6g} m; give (x, y, z, radius)",
                                      place(centre), radius));
    if (const double off = std::abs(baffle.normal().dot(centre - baffle.origin)); off > round_off * size)
      throw BadParameters(fmt::format("a hole at {} lies {:.6g} m off its baffle's plane; its centre must be in that",
                                      place(centre), off));
    const Vec<2> at = baffle.in_plane(centre);
    if (const double beyond = whole.rim(at).distance + radius; beyond > least)
      throw BadParameters(fmt::format(
          "a hole at {} of radius {:.6g} m goes {:.6g} m beyond its baffle's rim; move it, or make it smaller",
          place(centre), radius, std::max(0.0, beyond)));
    for (const auto& other : baffle.region.holes)
      if ((other.centre - at).norm() < other.radius + radius - least)
        throw BadParameters(fmt::format("the holes at {} and {} of a baffle overlap; move one, or make it smaller",
                                        place(baffle.placed(other.centre)), place(centre)));
    baffle.region.holes.push_back({at, radius});
  }
}

/// The part of a line in the plane that the region's outside and holes leave, as shares of a unit vector.
std::vector<std::array<double, 2>> chords(const FlatRegion& region, const Vec<2>& at, const Vec<2>& way) {
  const auto of_circle = [&](const Vec<2>& centre, double radius) {
    const double middle = way.dot(centre - at), squared = radius * radius - (at + middle * way - centre).squaredNorm();
    const double half = squared > 0 ? std::sqrt(squared) : 0;
    return std::array{middle - half, middle + half};
  };
  std::array<double, 2> whole = of_circle(Vec<2>::Zero(), region.half.norm() + region.round);
  if (!region.is_disc())
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(way[axis]) < 1e-12) {
        if (std::abs(at[axis]) >= region.half[axis]) return {};
        continue;
      }
      const double side = std::copysign(region.half[axis], way[axis]);
      whole[0] = std::max(whole[0], (-side - at[axis]) / way[axis]);
      whole[1] = std::min(whole[1], (side - at[axis]) / way[axis]);
    }
  std::vector<std::array<double, 2>> holes;
  for (const auto& hole : region.holes) holes.push_back(of_circle(hole.centre, hole.radius));
  std::sort(holes.begin(), holes.end());
  std::vector<std::array<double, 2>> all;
  for (const auto& [from, to] : holes) {
    if (!(to > from)) continue;
    all.push_back({whole[0], from});
    whole[0] = to;
  }
  all.push_back(whole);
  std::erase_if(all, [](const auto& chord) { return !(chord[1] > chord[0]); });
  return all;
}

}  // namespace

Vec<3> FlatBaffle::normal() const { return u.cross(v); }

Vec<2> FlatBaffle::in_plane(const Vec<3>& r) const { return {u.dot(r - origin), v.dot(r - origin)}; }

Vec<3> FlatBaffle::placed(const Vec<2>& r, double above) const {
  return origin + r[0] * u + r[1] * v + above * normal();
}

Nearest<3> FlatBaffle::nearest(const Vec<3>& r) const {
  const Vec<3> up = normal();
  const double height = up.dot(r - origin), side = height < 0 ? -1 : 1, half = 0.5 * thickness;
  const Vec<2> at = in_plane(r);
  const FlatRegion::Rim rim = region.rim(at);
  const double above = std::abs(height) - half;
  const bool by_rim = rim.distance > above;
  Nearest<3> result;
  result.distance = rim.distance > 0 && above > 0 ? std::hypot(rim.distance, above) : std::max(rim.distance, above);
  result.foot = placed(rim.distance > 0 || by_rim ? rim.foot : at, by_rim && above <= 0 ? height : side * half);
  const Vec<2> off = at - rim.foot;
  const Vec<3> out = off[0] * u + off[1] * v;
  result.normal = by_rim && !off.isZero() ? Vec<3>((rim.distance < 0 ? -1 : 1) * out.normalized()) : Vec<3>(side * up);
  return result;
}

FlatBaffle rectangle(const std::vector<std::array<double, 3>>& corners, const std::vector<std::array<double, 4>>& holes,
                     double thickness) {
  if (corners.size() != 3 && corners.size() != 4)
    throw BadParameters(fmt::format("a baffle's rectangle has {} corners; give three, or all four", corners.size()));
  const Vec<3> first = vec(corners[0]), second = vec(corners[1]), third = vec(corners[2]);
  const Vec<3> along = first - second, across = third - second, fourth = first + across;
  if (!(along.norm() > 0) || !(across.norm() > 0))
    throw BadParameters(fmt::format("a baffle has two corners at {}", place(second)));
  const double angle = std::acos(along.dot(across) / (along.norm() * across.norm())) * 180 / std::numbers::pi;
  if (std::abs(angle - 90) > 0.01)
    throw BadParameters(
        fmt::format("the corners of a baffle at {}, {} and {} make an angle of {:.4g} degrees; a "
                    "rectangle has 90",
                    place(first), place(second), place(third), angle));
  if (corners.size() == 4 && (vec(corners[3]) - fourth).norm() > 1e-4 * (along.norm() + across.norm()))
    throw BadParameters(fmt::format("the fourth corner of a baffle is {}; of a rectangle it would be {}",
                                    place(vec(corners[3])), place(fourth)));
  FlatBaffle baffle{"baffle", 0.5 * (first + third), along.normalized(), {}, {}, thickness};
  baffle.v = (across - across.dot(baffle.u) * baffle.u).normalized();
  baffle.region = {0.5 * Vec<2>(along.norm(), across.norm()), 0, {}};
  cut(holes, baffle);
  return baffle;
}

FlatBaffle disc(const std::array<double, 3>& centre, const std::array<double, 3>& normal, double radius,
                const std::vector<std::array<double, 4>>& holes, double thickness) {
  const Vec<3> way = vec(normal), at = vec(centre);
  if (!(way.norm() > 0))
    throw BadParameters(fmt::format("the normal of the baffle about {} is 0; give normal = [nx, ny, nz]", place(at)));
  // Along the axes where the normal is along one.
  const Vec<3> up = way.normalized();
  Vec<3> u = std::abs(up[0]) < 0.9 ? Vec<3>(Vec<3>::UnitX()) : Vec<3>(Vec<3>::UnitY());
  u = (u - u.dot(up) * up).normalized();
  FlatBaffle baffle{"baffle", at, u, up.cross(u), {Vec<2>::Zero(), radius, {}}, thickness};
  cut(holes, baffle);
  return baffle;
}

std::vector<BaffleLine> slice(const FlatBaffle& baffle, const SectionPlane& plane) {
  const int axis = static_cast<int>(plane.axis), across = 2 - axis;  // the run's x
  const Vec<2> slope(baffle.u[axis], baffle.v[axis]);
  const double away = plane.at - baffle.origin[axis], steepness = slope.norm();
  if (steepness < 1e-9) {
    if (std::abs(away) > 0.5 * baffle.thickness) return {};
    throw BadParameters(fmt::format("the {} about {} lies in the section {} = {:.6g} m; move that, or leave it out",
                                    baffle.name, place(baffle.origin), name(plane.axis), plane.at));
  }
  const Vec<2> at = away / (steepness * steepness) * slope, way = Vec<2>(-slope[1], slope[0]) / steepness;
  std::vector<BaffleLine> lines;
  for (const auto& chord : chords(baffle.region, at, way)) {
    BaffleLine line{{}, baffle.thickness / steepness, baffle.name};
    for (const double end : chord) {
      const Vec<3> r = baffle.placed(at + end * way);
      line.points.emplace_back(r[across], r[1]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace seiche::solver
