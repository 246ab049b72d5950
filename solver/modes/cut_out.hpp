#pragma once
#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// What solids and plates leave of a section: closed loops, the inside on their left, a plate there and back. What
/// lies within 1e-9 of the section's size is one point, so that a baffle may end on the wall, within it or beyond.
/// @param section outer loops anticlockwise, holes clockwise [m]
/// @param solids closed polygons, either way round; they may overlap each other and the wall
/// @param plates without thickness, each a line of points; they may cross each other and the wall
Polygons cut_out(const Polygons& section, const Polygons& solids, const Polygons& plates);

}  // namespace seiche::solver::modes
