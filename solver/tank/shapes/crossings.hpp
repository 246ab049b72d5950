#pragma once
#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// Where a line meets a wall.
struct Crossing {
  double at;  ///< along the line [m]
  int patch;
};

/// Exact, in ascending order: the liquid lies between the first and the second, the third and the fourth, ...
/// @param axis along which the line has the value: 0 for x = value, 1 for y = value
std::vector<Crossing> crossings(const Contour& wall, int axis, double value);

/// A point for a piece of a section.
struct AreaPoint {
  Vec<2> position;
  double area;  ///< [m^2]
};

/// Points in rows along x, about l0 apart, that fill a section; their areas sum to its area. Of a rectangle whose sides
/// are whole numbers of l0 they are the centres of its cells.
std::vector<AreaPoint> filled_rows(const Contour& wall, double l0);

}  // namespace seiche::solver
