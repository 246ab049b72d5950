#pragma once
#include <vector>

#include "solver/tank/level_axes.hpp"

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
CellPart<D> part_inside(const Shape<D>& tank, const Vec<D>& centre, double side,
                        const LevelAxes<D>& axes = LevelAxes<D>());

/// The parts into which baffles cut what of a cell lies inside a tank: of its small parts, those that see the first one
/// which is left, and so on. One where none is near.
template <int D>
std::vector<CellPart<D>> parts_inside(const Shape<D>& tank, const Baffles<D>* baffles, const Vec<D>& centre,
                                      double side, const LevelAxes<D>& axes = LevelAxes<D>());

}  // namespace seiche::solver
