#pragma once
#include "solver/modes/corner.hpp"

namespace seiche::solver::modes {

/// Cuts closed polygons, the inside on the left, along a level and closes what is below it by pieces of free surface.
/// A point at the level counts as above. Throws BadParameters where the ends of the pieces don't alternate between
/// walls that come down and go up.
/// @param level whole, as all coordinates are
std::vector<Loop> loops_below(double level, const std::vector<std::vector<Vec<2>>>& polygons);

}  // namespace seiche::solver::modes
