#pragma once
#include <limits>
#include <vector>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// A wall seen from one side: the plane normal.r = offset, its normal out of the tank.
template <int D>
struct Face {
  Vec<D> normal;
  double offset;  ///< [m]

  /// How far behind the wall r is, negative before it [m].
  double behind(const Vec<D>& r) const { return normal.dot(r) - offset; }
};

/// The normal of the face through which the way from liquid at `from` to a point `to` of the wall enters it; zero if
/// it enters through none. Beside an edge where the wall is convex it fills what lies behind all faces, so that is the
/// last one crossed.
template <int D>
Vec<D> entered_face(const std::vector<Face<D>>& faces, const Vec<D>& from, const Vec<D>& to) {
  Vec<D> normal = Vec<D>::Zero();
  double last = -std::numeric_limits<double>::infinity();
  for (const Face<D>& face : faces) {
    const double before = -face.behind(from), after = face.behind(to);
    if (before < 0 || after <= 0) continue;
    if (const double share = before / (before + after); share > last) last = share, normal = face.normal;
  }
  return normal;
}

}  // namespace seiche::solver
