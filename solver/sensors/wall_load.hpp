#pragma once
#include <array>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"
#include "solver/tank/facets.hpp"

namespace seiche::solver {

/// What the liquid does to the walls, in the tank's axes.
template <int D>
struct Load {
  Vec<D> force = Vec<D>::Zero();                     ///< integral of p n over the walls [N/m in 2-D, N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about a point; in 2-D about z alone [N m/m, N m]

  void operator+=(const Load& other) {
    force += other.force;
    moment += other.moment;
  }
};

/// Integrates the pressure over the facets of a wall: on each it is the linear fit of the fluid about its centre, where
/// positive, at the points of its quadrature, so that force and moment are exact on a hydrostatic field where the wall
/// is flat; a facet that the surface cuts is right to second order in l0. Facets with no fluid within 1.5 l0 are dry.
template <int D>
class WallLoad {
 public:
  /// @param pivot about which moments are [m]
  WallLoad(const SurfaceMesh& wall, const Vec<D>& pivot, double l0)
      : l0_(l0), pivot_(pivot), facets_(facets_of<D>(wall, l0)), loads_(facets_.size()) {}

  /// On all of it.
  Load<D> read(const State<D>& s, const FluidCells<D>& cells) {
    const int size = static_cast<int>(facets_.size());
#pragma omp parallel for schedule(static)
    for (int k = 0; k < size; ++k) loads_[k] = is_wet(facets_[k], s, cells) ? on(facets_[k], s, cells) : Load<D>{};
    Load<D> sum;
    for (const Load<D>& load : loads_) sum += load;
    return sum;
  }

  /// On a patch of it, as last read.
  Load<D> on_patch(int patch) const {
    Load<D> sum;
    for (std::size_t k = 0; k < facets_.size(); ++k)
      if (facets_[k].patch == patch) sum += loads_[k];
    return sum;
  }

 private:
  /// On the liquid's side.
  Vec<D> eye(const Facet<D>& facet) const {
    return facet.centre - eye_distance * l0_ * facet.points.front().area.normalized();
  }

  bool is_wet(const Facet<D>& facet, const State<D>& s, const FluidCells<D>& cells) const {
    bool wet = false;
    cells.near(facet.centre, [&](int j, const Vec<D>& offset) {
      wet |= offset.norm() < 1.5 * l0_ && (!s.baffles || s.baffles->sees(eye(facet), s.position[j]));
    });
    return wet;
  }

  Load<D> on(const Facet<D>& facet, const State<D>& s, const FluidCells<D>& cells) const {
    const LinearPressure<D> fit = fit_pressure(facet.centre, eye(facet), l0_, s, cells);
    Load<D> sum;
    for (const auto& [offset, area] : facet.points) {
      const Vec<D> force = std::max(0.0, fit.value + fit.slope.dot(offset)) * area;
      const Vec<D> arm = facet.centre - pivot_ + offset;
      sum.force += force;
      sum.moment[2] += arm[0] * force[1] - arm[1] * force[0];
      if constexpr (D == 3) {
        sum.moment[0] += arm[1] * force[2] - arm[2] * force[1];
        sum.moment[1] += arm[2] * force[0] - arm[0] * force[2];
      }
    }
    return sum;
  }

  double l0_;
  Vec<D> pivot_;
  std::vector<Facet<D>> facets_;
  std::vector<Load<D>> loads_;
};

}  // namespace seiche::solver
