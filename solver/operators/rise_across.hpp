#pragma once
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// (slope.n)(n.r), the part of slope.r across a wall; 0 in a corner, where no single normal exists (n = 0). The slope
/// along a wall is left out on both sides of a particle, so in a corner both parts are.
template <int D>
double rise_across(const Vec<D>& normal, const Vec<D>& slope, const Vec<D>& r) {
  return slope.dot(normal) * normal.dot(r);
}

}  // namespace seiche::solver
