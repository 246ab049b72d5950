#pragma once
#include <cmath>
#include <numbers>

#include "solver/modes/outline.hpp"

namespace seiche::test {

using solver::Vec;
using solver::modes::Polygons;

/// x from 0, y from 0.
inline Polygons box(double length, double height) { return {{{0, 0}, {length, 0}, {length, height}, {0, height}}}; }

/// Its lowest point at (0, 0).
inline Polygons circle(double radius, int sides = 720) {
  Polygons section(1);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    section[0].push_back({radius * std::sin(angle), radius - radius * std::cos(angle)});
  }
  return section;
}

/// The profile of a sphere: the right half of a circle, closed along the axis.
inline Polygons half_circle(double radius, int sides = 360) {
  Polygons section(1);
  for (int k = 0; k <= sides; ++k) {
    const double angle = std::numbers::pi * k / sides;
    section[0].push_back({k < sides ? radius * std::sin(angle) : 0, radius - radius * std::cos(angle)});
  }
  return section;
}

/// A box of 0.5 x 0.3 m with a wall of 0.1 m that stands in the middle of its floor; without thickness, a plate.
inline Polygons baffled(double thickness) {
  const double left = 0.25 - 0.5 * thickness, right = 0.25 + 0.5 * thickness;
  Polygons section{{{0, 0}, {left, 0}, {left, 0.1}}};
  if (thickness > 0) section[0].push_back({right, 0.1});
  for (const Vec<2>& at : {Vec<2>(right, 0), Vec<2>(0.5, 0), Vec<2>(0.5, 0.3), Vec<2>(0, 0.3)})
    section[0].push_back(at);
  return section;
}

}  // namespace seiche::test
