#pragma once
#include "solver/particles/neighbours.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// The fluid particles of one instant, sorted into cells as wide as the sensors reach. Sensors have cells of their own
/// since those of the neighbour list lag behind the particles by up to half a skin and one step.
template <int D>
class FluidCells {
 public:
  static constexpr double reach = 3;  ///< of `near` [l0]

  FluidCells(const Bounds<D>& tank, double l0) : grid_(tank.low, tank.high, reach * l0), reach_(reach * l0) {}

  /// Call when particles have moved, come or gone.
  void sort(const State<D>& s) {
    fluid_.clear();
    position_.clear();
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.kind[i] == Kind::fluid) {
        fluid_.push_back(static_cast<int>(i));
        position_.push_back(s.position[i]);
      }
    grid_.sort(position_, order_);
  }

  /// Calls f(j, r_j - point) for every fluid particle j nearer to the point than the reach, in a fixed order.
  template <class F>
  void near(const Vec<D>& point, F f) const {
    grid_.runs_near(point, [&](int first, int last) {
      for (int k = first; k < last; ++k) {
        const Vec<D> offset = position_[order_[k]] - point;
        if (offset.squaredNorm() < reach_ * reach_) f(fluid_[order_[k]], offset);
      }
    });
  }

 private:
  CellGrid<D> grid_;
  double reach_;
  std::vector<int> fluid_, order_;
  Vecs<D> position_;
};

}  // namespace seiche::solver
