#include "solver/tank/baffles/baffles_of.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

using Baffle = Parameters::Tank::Baffle;

/// What tells where a baffle is.
enum class Told { line, across, corners, disc };

Told told_of(const Baffle& baffle) {
  std::vector<Told> told;
  if (!baffle.points.empty()) told.push_back(Told::line);
  if (baffle.height > 0) told.push_back(Told::across);
  if (!baffle.corners.empty()) told.push_back(Told::corners);
  if (baffle.radius > 0) told.push_back(Told::disc);
  if (told.size() == 1) return told.front();
  throw BadParameters(fmt::format(
      "a [[tank.baffle]] has {}: give points (2-D), x with height, corners (3-D), or centre with radius (3-D)",
      told.empty() ? "nothing that tells where it is" : "several of its places"));
}

/// A rectangle across all of the tank, from its lowest point up.
FlatBaffle across(const Baffle& baffle, const Bounds<3>& bounds) {
  const double low = bounds.low[1], high = low + baffle.height;
  return rectangle({{baffle.x, low, bounds.low[2]}, {baffle.x, low, bounds.high[2]}, {baffle.x, high, bounds.high[2]}},
                   baffle.holes, baffle.thickness);
}

FlatBaffle flat(const Baffle& baffle, Told told) {
  return told == Told::corners ? rectangle(baffle.corners, baffle.holes, baffle.thickness)
                               : disc(baffle.centre, baffle.normal, baffle.radius, baffle.holes, baffle.thickness);
}

FlatBaffle ring_of(const Parameters::Tank::Ring& ring, double farthest) {
  const double outer = ring.outer > 0 ? ring.outer : farthest;
  const auto& [x, y, z] = ring.centre;
  if (ring.inner >= outer)
    throw BadParameters(
        fmt::format("the ring about ({:.6g}, {:.6g}, {:.6g}) m has the inner radius {:.6g} and the outer "
                    "{:.6g} m; the outer must be greater",
                    x, y, z, ring.inner, outer));
  FlatBaffle all = disc(ring.centre, ring.normal, outer, {{x, y, z, ring.inner}}, ring.thickness);
  all.name = "ring";
  return all;
}

/// Farther than any point of the tank is from a point.
double farthest_in(const Bounds<3>& bounds, const std::array<double, 3>& from) {
  return bounds.size().norm() + (Vec<3>(from.data()) - bounds.low).norm();
}

/// What a section of these bounds lies in.
Bounds<3> bounds_of(const Bounds<2>& flat, const SectionPlane& plane) {
  const int axis = static_cast<int>(plane.axis), across = 2 - axis;  // the run's x
  Bounds<3> bounds;
  for (auto [end, from] : {std::pair{&bounds.low, &flat.low}, {&bounds.high, &flat.high}}) {
    (*end)[axis] = plane.at;
    (*end)[across] = (*from)[0];
    (*end)[1] = (*from)[1];
  }
  return bounds;
}

void check_no_holes(const Baffle& baffle) {
  if (!baffle.holes.empty())
    throw BadParameters("[[tank.baffle]] holes need a run in 3-D; leave them out, or give two baffles with a gap");
}

}  // namespace

bool has_baffles(const Parameters::Tank& tank) { return !tank.baffles.empty() || !tank.rings.empty(); }

std::vector<BaffleLine> baffle_lines(const Parameters& p, const Bounds<2>& bounds) {
  std::vector<BaffleLine> lines;
  const auto cut = [&](const FlatBaffle& baffle) {
    for (BaffleLine& line : slice(baffle, *p.tank.section)) lines.push_back(std::move(line));
  };
  const auto check_section = [&](const char* what) {
    if (!p.tank.section)
      throw BadParameters(fmt::format(
          "{} needs a tank in 3-D: give tank.width (of a membrane tank.length), or points = [[x, y], ...] of "
          "a line in 2-D",
          what));
  };
  for (const Baffle& baffle : p.tank.baffles) {
    switch (const Told told = told_of(baffle)) {
      case Told::line: {
        check_no_holes(baffle);
        BaffleLine line{{}, baffle.thickness};
        for (const auto& [x, y] : baffle.points) line.points.emplace_back(x, y);
        lines.push_back(std::move(line));
        break;
      }
      case Told::across:
        check_no_holes(baffle);
        lines.push_back(
            {{{baffle.x, bounds.low[1]}, {baffle.x, bounds.low[1] + baffle.height}}, baffle.thickness, "baffle"});
        break;
      case Told::corners:
      case Told::disc:
        check_section(told == Told::corners ? "[[tank.baffle]] corners" : "[[tank.baffle]] radius");
        cut(flat(baffle, told));
    }
  }
  for (const auto& ring : p.tank.rings) {
    check_section("[[tank.ring]]");
    cut(ring_of(ring, farthest_in(bounds_of(bounds, *p.tank.section), ring.centre)));
  }
  return lines;
}

std::vector<FlatBaffle> flat_baffles(const Parameters& p, const Bounds<3>& bounds) {
  std::vector<FlatBaffle> all;
  for (const Baffle& baffle : p.tank.baffles) {
    const Told told = told_of(baffle);
    if (told == Told::line)
      throw BadParameters(
          "[[tank.baffle]] points are of a run in 2-D: give corners = [[x, y, z], ...] or centre and radius, or, for "
          "2-D, leave tank.width (of a membrane tank.length) out, or give tank.section");
    all.push_back(told == Told::across ? across(baffle, bounds) : flat(baffle, told));
  }
  for (const auto& ring : p.tank.rings) all.push_back(ring_of(ring, farthest_in(bounds, ring.centre)));
  return all;
}

}  // namespace seiche::solver
