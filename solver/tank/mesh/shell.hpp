#pragma once
#include <vector>

#include "solver/tank/mesh/mesh_surface.hpp"

namespace seiche::solver {

/// A piece of the solid behind a wall.
struct ShellPiece {
  Vec<3> at;     ///< its middle [m]
  float volume;  ///< [l0^3]
  float depth;   ///< of the middle [m]
};

/// The solid behind a tank's wall, of each layer k that between depths of k l0 and (k + 1) l0, in small cubes that are
/// cut where layers meet.
std::vector<std::vector<ShellPiece>> shell_of(const MeshSurface& surface, int layers, double l0);

}  // namespace seiche::solver
