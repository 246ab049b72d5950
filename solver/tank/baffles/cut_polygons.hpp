#pragma once
#include <functional>
#include <vector>

#include "solver/particles/face.hpp"

namespace seiche::solver {

/// A convex polygon in space, and several.
using Polygon3 = Vecs<3>;
using Polygons3 = std::vector<Polygon3>;

/// The part of a convex polygon that lies behind a plane, or before it; empty if there is none.
Polygon3 behind(const Polygon3& polygon, const Face<3>& plane);
Polygon3 before(const Polygon3& polygon, const Face<3>& plane);

/// What of a convex polygon lies where a signed distance is negative, in convex pieces; the whole where all of it is,
/// within the slack. Exact where the distance is that to a plane, of second order in the size of the pieces that a
/// curved one cuts.
/// @param slack so far beyond, it may all be kept [m]
/// @param finest pieces aren't parted any more [m]
Polygons3 inside(const Polygon3& polygon, const std::function<double(const Vec<3>&)>& distance, double slack,
                 double finest);

/// What of a convex polygon lies before any of the planes of a convex solid, in convex pieces.
Polygons3 outside(const Polygon3& polygon, const std::vector<Face<3>>& solid);

/// Adds to each polygon the corners of others that lie on its sides, so that pieces of one surface meet in whole sides.
void join_sides(Polygons3& polygons);

}  // namespace seiche::solver
