#pragma once
#include "solver/tank/mesh/mesh_tank.hpp"
#include "solver/tank/shapes/slice.hpp"

namespace seiche::solver {

/// The section of a mesh in a plane, as the other `slice` have it: exact, but that points within 1e-7 of the mesh's
/// size of the line between others are left out. Of a wall that lies in the plane, the section just before it. Throws
/// BadParameters where the plane misses the tank.
Section slice(const MeshTank& tank, const SectionPlane& plane);

}  // namespace seiche::solver
