#pragma once
#include "solver/tank/mesh/triangles.hpp"

namespace seiche::solver {

/// Solid angle of a triangle as seen from the origin, positive if its corners run clockwise there
/// (van Oosterom & Strackee 1983) [sr].
double solid_angle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c);

/// The generalised winding number of a surface, its solid angle over 4 pi: 1 inside, 0 outside, in between where it has
/// gaps (Jacobson, Kavan & Sorkine-Hornung 2013). Far pieces of the surface count as dipoles (Barill et al. 2018).
class WindingTree {
 public:
  /// Refers to the mesh.
  explicit WindingTree(const Triangles& mesh);

  /// Within 0.01 of the exact.
  double number(const Vec<3>& r) const;

 private:
  struct Node {
    Vec<3> centre;  ///< of area
    Vec<3> area;    ///< sum of the triangles' [m^2]
    double radius;  ///< of a ball about the centre that holds them [m]
    int first, last;
    int children[2] = {-1, -1};
  };

  int build(int first, int last);

  const Triangles* mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace seiche::solver
