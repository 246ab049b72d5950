#pragma once
#include <limits>

#include "solver/tank/box_tree.hpp"
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// What of a triangle a foot lies on: corner k, side k from corner k to the next, or within.
struct Foot {
  enum class On { corner, side, face };
  int triangle = -1;
  On on = On::face;
  int k = 0;
  Vec<3> at = Vec<3>::Zero();
  double squared_distance = 0;  ///< from the point that it is the foot of [m^2]
};

/// The point of a triangle nearest to r (Ericson 2005, section 5.1.5).
Foot foot_on(const Triangles& mesh, int triangle, const Vec<3>& r);

/// Finds the point of a surface nearest to another, exactly.
class Closest {
 public:
  /// Refers to the mesh.
  explicit Closest(const Triangles& mesh);

  /// @param within a distance at which or below which it is known to be [m]
  Foot foot(const Vec<3>& r, double within = std::numeric_limits<double>::infinity()) const;

 private:
  const Triangles* mesh_;
  BoxTree<3> tree_;
};

}  // namespace seiche::solver
