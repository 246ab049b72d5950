#pragma once
#include <vector>

#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// The edge of a hole: points of the mesh, in the order in which triangles that close it have them.
using HoleLoop = std::vector<int>;

/// The edges of all holes, of a mesh that faces one way: round each the sides that one triangle alone has.
std::vector<HoleLoop> loops_of(const Triangles& mesh);

/// Triangles that close a loop, as places in it: ears are cut off, that with the shortest new side first, so that long
/// slits are closed from side to side.
std::vector<std::array<int, 3>> ears_of(const Triangles& mesh, const HoleLoop& loop);

}  // namespace seiche::solver
