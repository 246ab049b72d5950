#pragma once
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// a x b
inline double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// A piece of a section's wall: a straight line, or an arc of less than a circle.
struct Edge {
  Vec<2> from, to;  ///< the liquid lies on the left of the way from one to the other [m]
  double bulge;     ///< tan of a quarter of the arc's angle, positive if it turns left (as in DXF); 0: a straight line
  int patch;

  /// Signed angle of the arc [rad].
  double angle() const;
  /// Of the arc [m].
  double radius() const;
  Vec<2> centre() const;
  double length() const;
  /// At a share of its length from `from`.
  Vec<2> point(double share) const;
  /// Out of the tank, there.
  Vec<2> normal(double share) const;
  /// Share of the length at which the point nearest to r lies.
  double nearest_share(const Vec<2>& r) const;
};

}  // namespace seiche::solver
