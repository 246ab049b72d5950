#pragma once
#include <vector>

#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// A side of a triangle: side k goes from its corner k to the next.
struct Side {
  int triangle, k;
};

/// The two points that a side joins, the lower number first.
struct MeshEdge {
  int low, high;
  std::vector<Side> sides;  ///< of the triangles that meet there
};

std::vector<MeshEdge> edges_of(const Triangles& mesh);

/// Where a side begins and ends.
inline int begin_of(const Triangles& mesh, const Side& side) { return mesh.corners[side.triangle][side.k]; }
inline int end_of(const Triangles& mesh, const Side& side) { return mesh.corners[side.triangle][(side.k + 1) % 3]; }

/// Whether two sides of one edge run against each other, as those of triangles that face the same way do.
inline bool are_opposite(const Triangles& mesh, const Side& a, const Side& b) {
  return begin_of(mesh, a) == end_of(mesh, b);
}

}  // namespace seiche::solver
