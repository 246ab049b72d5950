#pragma once
#include <string>

#include "solver/tank/mesh/holes.hpp"
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// What was wrong with a mesh, for the user.
struct MeshFaults {
  LeftOut left_out;
  int slivers = 0;  ///< triangles without an area, and sides that had to be cut at points of others
  int turned = 0;   ///< triangles that faced the other way
  Holes holes;      ///< that were closed
};

/// As in "12 triangles turned round; 2 holes closed, the widest 1.2 mm across"; empty where nothing was wrong.
std::string text_of(const MeshFaults& faults);

/// The surface of a tank: closed, and facing outwards (away from the liquid).
struct Mended {
  Triangles mesh;
  MeshFaults faults;
  /// No side has more than two triangles, and nowhere does it pass through itself: the nearest triangle tells the sign.
  bool simple = true;
};

/// Makes a closed surface of a mesh as users have them: joins its triangles, takes out those without an area, turns
/// them to face one way, closes holes; parts inside others become holes of the tank. Throws BadParameters where a hole
/// is wider than `widest` [m], a sheet splits the inside, or the surface passes through itself by more than a tenth of
/// that, and where.
Mended mended(const SurfaceMesh& mesh, double widest);

}  // namespace seiche::solver
