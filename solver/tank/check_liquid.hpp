#pragma once
#include "solver/parameters.hpp"
#include "solver/surface_mesh.hpp"

namespace seiche::solver {

/// Throws BadParameters for liquid that the tank can't hold, or that particles of this spacing can't make.
/// @param wall_in_tank in the tank's frame
void check_liquid(const Parameters& p, const SurfaceMesh& wall_in_tank);

}  // namespace seiche::solver
