#pragma once
#include <algorithm>
#include <cmath>

#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// What of a square or cubic cell lies inside a tank.
template <int D>
struct CellPart {
  double share;     ///< of the cell's volume
  Vec<D> centroid;  ///< [m]
};

/// By the tank's signed distance d at the centres of 8^2 or 6^3 parts, each taken to be cut square to its side: it has
/// the share 1/2 - d/side. Exact where the cell is cut by one wall along an axis; within some 1e-3 else.
template <int D>
CellPart<D> part_inside(const Shape<D>& tank, const Vec<D>& centre, double side) {
  const double beyond = tank.nearest(centre).distance, half_diagonal = 0.5 * std::sqrt(D) * side;
  if (beyond <= -half_diagonal) return {1, centre};
  if (beyond >= half_diagonal) return {0, centre};
  constexpr int parts = D == 2 ? 8 : 6, all = D == 2 ? parts * parts : parts * parts * parts;
  const double part = side / parts;
  double sum = 0;
  Vec<D> moment = Vec<D>::Zero();
  for (int k = 0; k < all; ++k) {
    Vec<D> offset;
    for (int a = 0, rest = k; a < D; ++a, rest /= parts) offset[a] = (rest % parts + 0.5) * part - 0.5 * side;
    const double share = std::clamp(0.5 - tank.nearest(centre + offset).distance / part, 0.0, 1.0);
    sum += share;
    moment += share * offset;
  }
  if (sum < 1e-6 * all) return {0, centre};
  if (sum > (1 - 1e-6) * all) return {1, centre};
  return {sum / all, centre + moment / sum};
}

}  // namespace seiche::solver
