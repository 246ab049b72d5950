#pragma once
#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// Convex polygons that fill what the loops go round, counter-clockwise: the loop itself if it is one and convex, else
/// trapezoids between the heights of its corners.
std::vector<Vecs<2>> flat_faces(const std::vector<std::vector<Contour::Corner>>& loops);

}  // namespace seiche::solver
