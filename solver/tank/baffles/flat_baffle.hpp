#pragma once
#include "solver/parameters.hpp"
#include "solver/tank/baffles/outline.hpp"

namespace seiche::solver {

/// A flat baffle in 3-D: a rectangle or a disc, with circular holes; a ring is a disc with a hole in its middle.
struct FlatBaffle {
  std::string name;     ///< its patch
  Vec<3> origin, u, v;  ///< of the region's plane, the middle of its thickness: a point [m], and unit vectors along it
  FlatRegion region;
  double thickness = 0;  ///< half on each side [m]; 0: a plate

  Vec<3> normal() const;
  Vec<2> in_plane(const Vec<3>& r) const;
  Vec<3> placed(const Vec<2>& r, double above = 0) const;

  /// As seen from a point: the distance to it, negative within it; the normal is out of it. Exact.
  Nearest<3> nearest(const Vec<3>& r) const;
};

/// Of three corners of a rectangle, the second beside both others, or all four in their order.
/// @param holes (x, y, z, radius)
/// Throws BadParameters where they are none, and for holes off its plane, outside of it or over each other, with the
/// place. So do the others.
FlatBaffle rectangle(const std::vector<std::array<double, 3>>& corners, const std::vector<std::array<double, 4>>& holes,
                     double thickness);

FlatBaffle disc(const std::array<double, 3>& centre, const std::array<double, 3>& normal, double radius,
                const std::vector<std::array<double, 4>>& holes, double thickness);

/// What a plane cuts of it, in the coordinates of the tank's section there: a line for each part. Throws BadParameters
/// where it lies in that plane.
std::vector<BaffleLine> slice(const FlatBaffle& baffle, const SectionPlane& plane);

}  // namespace seiche::solver
