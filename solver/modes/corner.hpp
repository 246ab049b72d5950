#pragma once
#include <vector>

#include "solver/particles/vec.hpp"

namespace seiche::solver::modes {

/// Begins an edge of the liquid's outline, which is free surface or wall.
struct Corner {
  Vec<2> at;
  bool surface;
};

/// A closed polygon, the liquid on its left.
using Loop = std::vector<Corner>;

/// Twice the area to the left of a -> b -> c.
inline double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace seiche::solver::modes
