#pragma once
#include <vector>

#include "solver/tank/contour.hpp"
#include "solver/tank/wall_point.hpp"

namespace seiche::solver {

/// A vertex of a section's wall.
struct Bend {
  Vec<2> at;
  double turn;  ///< positive where the liquid side is under 180 degrees [rad]
  Face<2> before, after;
};

/// What the wall is to a point behind it.
struct Behind {
  Vec<2> normal;
  int patch;
  std::vector<Face<2>> faces;
};

/// The vertices of a wall that turn by more than 5 degrees.
class Bends {
 public:
  explicit Bends(const Contour& wall);

  /// Normal, patch and faces of a wall point (`WallPoint`). Corners of the tank that turn by less than 30 degrees pass
  /// for curved walls: behind them the normal is the direction from the vertex.
  /// @param reach of the faces [m]
  Behind behind(const Contour& wall, const Vec<2>& r, double reach) const;

 private:
  std::vector<Bend> bends_;
};

}  // namespace seiche::solver
