#pragma once
#include <string>
#include <vector>

#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// A baffle in 2-D: a polyline, with a thickness or without [m].
struct BaffleLine {
  std::vector<Vec<2>> points;
  double thickness = 0;         ///< 0: a plate
  std::string name = "baffle";  ///< its patch; several of one name are numbered
};

/// What goes round a baffle: closed, the baffle on its left. Of a plate it is its points, there and back; else each end
/// is cut square to the line, and bends are mitred. Throws BadParameters where the line has fewer than two points, two
/// that follow each other in one place, or turns back so sharply that its thickness has no room.
std::vector<Vec<2>> outline_of(const BaffleLine& baffle);

/// Shares of the way from a to b at which it crosses the walk, ascending, within (0, 1).
std::vector<double> crossings_of(const Vec<2>& a, const Vec<2>& b, const std::vector<Vec<2>>& closed_walk);

/// The same, with those that there are several of numbered: "baffle_1", "baffle_2", ...
std::vector<std::string> numbered(const std::vector<std::string>& names);

}  // namespace seiche::solver
