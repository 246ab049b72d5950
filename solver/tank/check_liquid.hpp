#pragma once
#include "solver/parameters.hpp"
#include "solver/surface_mesh.hpp"

namespace seiche::solver {

/// Throws BadParameters for liquid that the tank can't hold, or that particles of this spacing can't make.
void check_liquid(const Parameters& p, const SurfaceMesh& wall);

}  // namespace seiche::solver
