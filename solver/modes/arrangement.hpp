#pragma once
#include <array>
#include <set>
#include <utility>

#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// A way between two points, by their numbers.
using Way = std::pair<int, int>;

/// Lines in the plane cut where they meet: points, and straight ways between them that meet at their ends alone.
struct Arrangement {
  std::vector<Vec<2>> points;
  std::vector<std::vector<Way>> ways;  ///< of each line, in its direction
};

/// @param lines from one point to another
/// @param tolerance within which points are one [m]
Arrangement arranged(const std::vector<std::array<Vec<2>, 2>>& lines, double tolerance);

/// Closed walks along ways, each used once, with what is on their left: at each point to the first on the left hand.
Polygons walks(const std::vector<Vec<2>>& points, std::set<Way> ways);

}  // namespace seiche::solver::modes
