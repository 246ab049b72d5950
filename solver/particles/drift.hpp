#pragma once
#include <limits>

#include "solver/particles/cell_grid.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// How far particles have moved since they were listed, relative to those near them. Liquid that moves as a whole needs
/// no new list, however fast it is.
template <int D>
class Drift {
 public:
  /// Whether two particles that lay at most two cells apart, on each axis, when they were listed may have come nearer
  /// to each other by more than `relative`, or any has moved by more than `absolute`. `grid` is as it was sorted then.
  bool exceeds(double relative, double absolute, const CellGrid<D>& grid, const State<D>& s) {
    const int cells = grid.cells();
    double moved = 0;
    resize_kept(own_, cells);
#pragma omp parallel for schedule(static) reduction(max : moved)
    for (int c = 0; c < cells; ++c) {
      own_[c] = {};
      const auto [first, last] = grid.points(c);
      for (int i = first; i < last; ++i) {
        const Vec<D> by = s.position[i] - s.listed_position[i];
        own_[c].take_in({by, by});
        moved = std::max(moved, by.squaredNorm());
      }
    }
    if (!(moved <= absolute * absolute)) return true;
    // Cheap and nearly always enough in a calm tank.
    if (4 * moved <= relative * relative) return false;

    near_ = own_;
    for (int axis = 0, stride = 1; axis < D; stride *= grid.cells_along()[axis++])
      widen(stride, grid.cells_along()[axis]);
    bool beyond = false;
#pragma omp parallel for schedule(static) reduction(|| : beyond)
    for (int c = 0; c < cells; ++c) {
      if (!(own_[c].low[0] <= own_[c].high[0])) continue;  // empty
      const Vec<D> most = (near_[c].high - own_[c].low).cwiseMax(own_[c].high - near_[c].low);
      beyond = beyond || !(most.squaredNorm() <= relative * relative);
    }
    return beyond;
  }

 private:
  /// The smallest box that displacements lie in [m].
  struct Box {
    Vec<D> low = Vec<D>::Constant(std::numeric_limits<double>::infinity());
    Vec<D> high = -low;
    void take_in(const Box& other) {
      low = low.cwiseMin(other.low);
      high = high.cwiseMax(other.high);
    }
  };

  /// Each cell's box takes in those up to two cells away along an axis.
  void widen(int stride, int along) {
    const int cells = static_cast<int>(near_.size());
    narrow_ = near_;
#pragma omp parallel for schedule(static)
    for (int c = 0; c < cells; ++c) {
      const int place = c / stride % along;
      for (int k = std::max(-2, -place); k <= std::min(2, along - 1 - place); ++k)
        near_[c].take_in(narrow_[c + k * stride]);
    }
  }

  std::vector<Box> own_, near_, narrow_;
};

}  // namespace seiche::solver
