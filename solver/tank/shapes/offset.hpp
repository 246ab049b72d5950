#pragma once
#include "solver/tank/shapes/path.hpp"

namespace seiche::solver {

/// The curve that lies `distance` [m] behind the wall. It is mitred at corners of the tank up to 1.5 `distance` from
/// the corner (liquid side from 84 to 180 degrees) and round about sharper ones; where another part of the wall is
/// nearer, as behind a convex edge of the solid, it has an end.
/// @param right_half only what has no negative first coordinate
std::vector<Path> offset_wall(const Contour& wall, double distance, bool right_half = false);

}  // namespace seiche::solver
