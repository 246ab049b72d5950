#pragma once
#include <vector>

#include "solver/particles/face.hpp"
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// A point behind the wall that stands for a piece of solid, on layer k (from 0) at (k + 1/2) l0 behind the surface.
template <int D>
struct WallPoint {
  Vec<D> position;  ///< [m]
  /// Out of the tank at the nearest point of the wall; zero beyond a corner of the tank, where the nearest point is a
  /// vertex or an edge whose liquid side is under 180 degrees.
  Vec<D> normal;
  double weight;  ///< of the solid [l0^D]
  int layer;
  int patch;                   ///< that the nearest point is on
  std::vector<Face<D>> faces;  ///< that a pair may cross; only beside an edge whose liquid side is over 180 degrees
  int behind = -1;             ///< face of a baffle that it stands behind (`Baffles`), -1 of the tank's own wall
};

}  // namespace seiche::solver
