#pragma once
#include "solver/tank/mesh/loops.hpp"

namespace seiche::solver {

/// How wide a hole is, and where.
struct HoleSize {
  double width = 0;  ///< twice the distance from its middle to its edge: of the largest ball that passes, about [m]
  Vec<3> middle = Vec<3>::Zero();
};

/// @param ears that close it
HoleSize size_of(const Triangles& mesh, const HoleLoop& loop, const std::vector<std::array<int, 3>>& ears);

struct Holes {
  int count = 0, open_sides = 0;
  double widest = 0;  ///< [m]
};

/// Closes the holes of a mesh that faces one way. Throws BadParameters where one is wider than a length, with the place
/// and the width of the widest.
/// @param widest that is closed [m]
Holes close_holes(Triangles& mesh, double widest);

}  // namespace seiche::solver
