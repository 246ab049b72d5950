#pragma once
#include "solver/surface_mesh.hpp"

namespace seiche::solver {

/// The space inside a tank's wall below a level y [m^2 in 2-D, m^3]: by the divergence theorem the integral of x n_x
/// over the wall below it, to which a level surface and a roof that is left out add nothing. Exact for the mesh.
double volume_below(const SurfaceMesh& wall, double level);

/// All the space inside, up to the rim of an open tank.
double volume_of(const SurfaceMesh& wall);

/// Of the wall [m in 2-D, m^2].
double area_of(const SurfaceMesh& wall);

/// The level y [m] below which the tank holds that volume, by bisection; its highest point if it holds less.
double level_holding(const SurfaceMesh& wall, double volume);

}  // namespace seiche::solver
