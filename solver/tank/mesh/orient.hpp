#pragma once
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// Turns triangles so that those which share a side face the same way, and numbers the parts of the surface that hang
/// together so. Returns the part of each triangle. Throws BadParameters where a surface has one side only.
std::vector<int> face_one_way(Triangles& mesh);

void turn(Triangles& mesh, int triangle);

/// Turns the closed parts so that they face away from the liquid: outwards, but inwards if they lie inside an odd
/// number of others.
/// @param part of each triangle
void face_outwards(Triangles& mesh, const std::vector<int>& part);

}  // namespace seiche::solver
