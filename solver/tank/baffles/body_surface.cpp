#include "solver/tank/baffles/body_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/tank/shapes/flat_faces.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;

/// Corners of a disc's and of a hole's rim.
constexpr int around_disc = 180, around_hole = 60;

/// A regular polygon of a circle's area, its corners counter-clockwise.
Vecs<2> circle(const Vec<2>& centre, double radius, int corners) {
  const double angle = 2 * pi / corners, scaled = radius * std::sqrt(angle / std::sin(angle));
  Vecs<2> points;
  for (int k = 0; k < corners; ++k)
    points.emplace_back(centre + scaled * Vec<2>(std::cos(k * angle), std::sin(k * angle)));
  return points;
}

/// Whether it is a ring: its hole has as many corners as its outer rim.
bool is_ring(const FlatRegion& region) {
  return region.is_disc() && region.holes.size() == 1 && region.holes[0].centre.norm() < 1e-9 * region.round;
}

Vecs<2> outline(const FlatRegion& region) {
  if (region.is_disc()) return circle(Vec<2>::Zero(), region.round, around_disc);
  const double x = region.half[0], y = region.half[1];
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Vecs<2> rim_of_hole(const FlatRegion& region, std::size_t k) {
  const auto& hole = region.holes[k];
  return circle(hole.centre, hole.radius, is_ring(region) ? around_disc : around_hole);
}

/// Moves corners of a disc's outline beyond the tank's wall back to that, towards the disc's middle or a ring's
/// opening, so that pieces end on the wall.
void pull_back(const FlatBaffle& baffle, const Shape<3>& tank, Vecs<2>& corners) {
  const auto is_inside = [&](const Vec<2>& r) { return tank.nearest(baffle.placed(r)).distance < 0; };
  const double from = is_ring(baffle.region) ? baffle.region.holes[0].radius / baffle.region.round : 0;
  for (Vec<2>& corner : corners) {
    double inside = from, outside = 1;
    if (!is_inside(inside * corner) || is_inside(corner)) continue;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (inside + outside);
      (is_inside(middle * corner) ? inside : outside) = middle;
    }
    corner *= inside;
  }
}

/// The region in convex pieces, counter-clockwise.
std::vector<Vecs<2>> pieces_of(const FlatRegion& region, const Vecs<2>& outer) {
  if (is_ring(region)) {
    const Vecs<2> inner = rim_of_hole(region, 0);
    std::vector<Vecs<2>> pieces;
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const std::size_t next = (k + 1) % outer.size();
      pieces.push_back({inner[k], outer[k], outer[next], inner[next]});
    }
    return pieces;
  }
  std::vector<std::vector<Contour::Corner>> loops;
  const auto add = [&](const Vecs<2>& corners) {
    auto& loop = loops.emplace_back();
    for (const Vec<2>& r : corners) loop.push_back({r, 0});
  };
  add(outer);
  for (std::size_t k = 0; k < region.holes.size(); ++k) add(rim_of_hole(region, k));
  return flat_faces(loops);
}

/// The walls of a thick baffle along a rim whose corners go round the solid counter-clockwise, or clockwise round a
/// hole.
void add_walls(const FlatBaffle& baffle, const Vecs<2>& rim, const std::vector<bool>& left_out, bool of_hole,
               Polygons3& all) {
  const double half = 0.5 * baffle.thickness;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    if (!left_out.empty() && left_out[k]) continue;
    Vec<2> from = rim[k], to = rim[(k + 1) % rim.size()];
    if (of_hole) std::swap(from, to);
    // The solid lies on the left of the way; seen from within it, counter-clockwise.
    all.push_back(
        {baffle.placed(to, -half), baffle.placed(from, -half), baffle.placed(from, half), baffle.placed(to, half)});
  }
}

/// Planes of the prism that stands on a convex polygon, their normals out of it.
std::vector<Face<3>> prism_on(const FlatBaffle& baffle, const Vecs<2>& corners) {
  const Vec<3> up = baffle.normal();
  const double half = 0.5 * baffle.thickness;
  std::vector<Face<3>> planes{{up, up.dot(baffle.origin) + half}, {-up, -up.dot(baffle.origin) + half}};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2> way = (corners[(k + 1) % corners.size()] - corners[k]).normalized();
    const Vec<3> out = way[1] * baffle.u - way[0] * baffle.v;
    planes.push_back({out, out.dot(baffle.placed(corners[k]))});
  }
  return planes;
}

}  // namespace

Polygons3 polygons_of(const FlatBaffle& baffle, const Rims& rims, const Shape<3>& tank, double l0, double touching) {
  Vecs<2> outer = outline(baffle.region);
  if (baffle.region.is_disc() && rims.outer[0].on_wall) pull_back(baffle, tank, outer);
  Polygons3 whole;
  for (const Vecs<2>& piece : pieces_of(baffle.region, outer))
    for (const double side : {1.0, -1.0}) {
      Polygon3 polygon;
      for (const Vec<2>& r : piece) polygon.push_back(baffle.placed(r, side * 0.5 * baffle.thickness));
      if (side > 0) std::reverse(polygon.begin(), polygon.end());
      whole.push_back(std::move(polygon));
    }
  if (baffle.thickness > 0) {
    const bool is_disc = baffle.region.is_disc();
    const auto on_wall = [&](std::size_t side) { return rims.outer[side].on_wall; };
    if (!is_disc)  // its outline's sides are those at -v, +u, +v, -u
      add_walls(baffle, outer, {on_wall(2), on_wall(1), on_wall(3), on_wall(0)}, false, whole);
    else if (!on_wall(0))
      add_walls(baffle, outer, {}, false, whole);
    for (std::size_t k = 0; k < baffle.region.holes.size(); ++k)
      if (!rims.holes[k].on_wall) add_walls(baffle, rim_of_hole(baffle.region, k), {}, true, whole);
  }
  Polygons3 all;
  const auto distance = [&](const Vec<3>& r) { return tank.nearest(r).distance; };
  for (const Polygon3& polygon : whole)
    for (Polygon3& part : inside(polygon, distance, touching, 0.25 * l0)) all.push_back(std::move(part));
  join_sides(all);
  return all;
}

void cut_out_baffle(const FlatBaffle& longer, Polygons3& polygons) {
  const std::vector<Face<3>> whole = prism_on(longer, outline(longer.region));
  Polygons3 kept;
  bool any = false;
  for (Polygon3& polygon : polygons) {
    Vec<3> middle = Vec<3>::Zero();
    for (const Vec<3>& r : polygon) middle += r / static_cast<double>(polygon.size());
    double extent = 0;
    for (const Vec<3>& r : polygon) extent = std::max(extent, (r - middle).norm());
    if (longer.nearest(middle).distance > extent) {
      kept.push_back(std::move(polygon));
      continue;
    }
    any = true;
    for (Polygon3& part : outside(polygon, whole)) kept.push_back(std::move(part));
    for (std::size_t k = 0; k < longer.region.holes.size(); ++k) {
      Polygon3 in_hole = polygon;
      for (const Face<3>& plane : prism_on(longer, rim_of_hole(longer.region, k)))
        if (!in_hole.empty()) in_hole = before(in_hole, plane);
      if (!in_hole.empty()) kept.push_back(std::move(in_hole));
    }
  }
  polygons = std::move(kept);
  if (any) join_sides(polygons);
}

}  // namespace seiche::solver
