#pragma once
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// Takes out triangles without an area, and leaves the surface as closed as it was: those on the other side of such a
/// triangle's longest side are cut in two at its third corner. Returns how many.
/// @param height below which a triangle has no area [m]
int take_out_slivers(Triangles& mesh, double height);

/// Cuts triangles whose open side passes through open ends of others, so that they share that point ("T junctions").
/// Returns how many times.
/// @param tolerance within which a side passes through a point [m]
int cut_at_points_on_sides(Triangles& mesh, double tolerance);

}  // namespace seiche::solver
