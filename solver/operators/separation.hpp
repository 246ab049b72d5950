#pragma once
#include "solver/operators/close_pairs.hpp"
#include "solver/parameters.hpp"

namespace seiche::solver {

/// Parts pairs that have come too close, by the model that the scene names.
template <int D>
class Separation {
 public:
  explicit Separation(const Parameters& p)
      : model_(p.method.separation),
        l0_(p.particles.spacing),
        distance_(p.method.separation_distance * p.particles.spacing) {}

  /// @param nearest as that of collide_with_walls()
  template <class Wall>
  void operator()(const Wall& nearest, const Neighbours<D>& list, State<D>& s) {
    switch (model_) {
      case SeparationModel::collide:
        collide_close_pairs(distance_, l0_, s.near_surface, list, s, buffers_);
        return collide_with_walls(distance_, l0_, s.near_surface, buffers_.at_wall, nearest, list, s);
      case SeparationModel::part:
        return part_close_pairs(distance_, list, s, buffers_.change);
      case SeparationModel::none:
        return;
    }
  }

 private:
  SeparationModel model_;
  double l0_, distance_;  ///< [m]
  Collisions<D> buffers_;
};

}  // namespace seiche::solver
