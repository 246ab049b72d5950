#pragma once
#include "solver/tank/mesh/mesh_surface.hpp"

namespace seiche::solver {

/// The points behind the wall of a mesh, as `Shape::wall_points` has them. Each stands for the solid between its
/// layer's limits that is nearest to it; solid too thin for a layer's points counts for those of the layer before.
std::vector<WallPoint<3>> lining_of(const MeshSurface& surface, int layers, double l0, double reach);

}  // namespace seiche::solver
