#pragma once
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// Where a surface passes through itself: a side of one triangle through another.
struct SelfCrossing {
  double depth = 0;  ///< how far the side goes beyond, on the side where that is less; 0: nowhere [m]
  Vec<3> at = Vec<3>::Zero();
};

/// The deepest, of those where triangles cross that share no corner.
SelfCrossing self_crossing(const Triangles& mesh);

}  // namespace seiche::solver
