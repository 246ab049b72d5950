#pragma once
#include <functional>

#include "solver/modes/triangle_mesh.hpp"

namespace seiche::solver::modes {

/// Splits triangles until none has an edge longer than the size at its centroid: the edge that is split is the longest
/// of both triangles beside it, found by going from each to the one beyond its longest edge (Rivara 1997, longest-edge
/// propagation path).
void refine(TriangleMesh& mesh, const std::function<double(const Vec<2>&)>& size);

}  // namespace seiche::solver::modes
