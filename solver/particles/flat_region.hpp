#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// A region of a plane: what lies within `round` of a rectangle about the origin, so a rectangle itself, or a disc
/// where that is a point, less circular holes. Holes lie within it, apart from each other.
struct FlatRegion {
  struct Hole {
    Vec<2> centre;  ///< [m]
    double radius;  ///< [m]
  };

  Vec<2> half;   ///< sides of the rectangle, halved [m]; 0: a disc
  double round;  ///< [m]; of a disc its radius
  std::vector<Hole> holes;

  bool is_disc() const { return half.isZero(); }

  /// The nearest point of its rim, and the distance to that, negative within the region. Exact.
  struct Rim {
    double distance;  ///< [m]
    Vec<2> foot;
  };
  Rim rim(const Vec<2>& r) const {
    Rim nearest = outer_rim(r);
    for (const Hole& hole : holes) {
      const Vec<2> off = r - hole.centre;
      const double from_centre = off.norm(), within = hole.radius - from_centre;
      if (within <= nearest.distance) continue;
      const Vec<2> way = from_centre > 0 ? Vec<2>(off / from_centre) : Vec<2>(Vec<2>::UnitX());
      nearest = {within, hole.centre + hole.radius * way};
    }
    return nearest;
  }

 private:
  Rim outer_rim(const Vec<2>& r) const {
    const Vec<2> core = r.cwiseMax(-half).cwiseMin(half), off = r - core;
    if (const double beyond = off.norm(); beyond > 0) return {beyond - round, core + round / beyond * off};
    const Vec<2> inside = half - r.cwiseAbs();
    const int axis = inside[0] < inside[1] ? 0 : 1;
    Vec<2> foot = r;
    foot[axis] = std::copysign(half[axis] + round, r[axis]);
    return {-inside[axis] - round, foot};
  }
};

}  // namespace seiche::solver
