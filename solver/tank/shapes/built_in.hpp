#pragma once
#include "solver/tank/shapes/extruded.hpp"
#include "solver/tank/shapes/head.hpp"
#include "solver/tank/shapes/revolved.hpp"

// The tanks that have a name, from plain numbers [m]. Each throws BadParameters where a number doesn't fit. All but the
// prism have the lowest point of their axis or middle plane at (0, 0, 0). A 2-D run takes a slice of them.
namespace seiche::solver {

/// A polygon, either way round, in its own x and y; z from 0 to width. Patches: edge_1 from the first point to the
/// second, ..., near, far.
Extruded prism(const std::vector<Vec<2>>& points, double width);

/// A rectangle, y from 0 to height, with its corners cut by (across, up); x and z from -1/2 to 1/2 of breadth and
/// length. Patches: floor, lower_right, right, upper_right, roof, upper_left, left, lower_left as far as there are
/// such, near, far.
Extruded membrane(double breadth, double height, const Vec<2>& lower_chamfer, const Vec<2>& upper_chamfer,
                  double length);

/// @param length of the straight shell: heads come on top of it
/// Patches: shell, then lower_head and upper_head (upright), left_head and right_head (along x), near_head and far_head
/// (along z).
Revolved cylinder(double radius, double length, Axis axis, Head ends);

/// Its only patch is the shell.
Revolved sphere(double radius);

/// @param points (height, radius) of a profile that turns about the vertical. Where an end isn't on the axis, a level
///        disc closes it; a profile that comes back to its first point is a ring. Patches: edge_1 from the first point
///        to the second, ..., and first_end, last_end, the discs. Heights are moved so that the lowest is 0.
Revolved revolve(const std::vector<Vec<2>>& points);

}  // namespace seiche::solver
