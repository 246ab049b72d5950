#pragma once
#include "solver/modes/corner.hpp"

namespace seiche::solver::modes {

/// Closed polygons, the inside on the left: outer ones anticlockwise, holes clockwise. [m]
using Polygons = std::vector<std::vector<Vec<2>>>;

/// One body of liquid, in units of a fine grid: its coordinates are whole numbers small enough for their products to be
/// exact, so that which way a corner turns is never in doubt.
struct Outline {
  Loop outer;               ///< anticlockwise
  std::vector<Loop> holes;  ///< clockwise, or a line there and back: a plate without thickness
  Vec<2> origin;            ///< [m]
  double unit;              ///< [m]

  Vec<2> place(const Vec<2>& at) const { return origin + unit * at; }
};

/// What lies below a level, a body for each chamber, those without a free surface left out. Moves points by up to
/// 2e-8 of the section's size. Throws BadParameters where a coordinate isn't finite, nothing lies below the level, it
/// is above the section, or the section crosses itself at the level.
/// @param level second coordinate of the free surface [m]
std::vector<Outline> liquid_below(double level, const Polygons& section);

}  // namespace seiche::solver::modes
