#pragma once
#include <array>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/tank/facets.hpp"

namespace seiche::solver {

/// What the liquid does to the walls.
template <int D>
struct Load {
  Vec<D> force = Vec<D>::Zero();  ///< integral of p n over the walls, in the tank's axes [N/m in 2-D, N]
  double moment = 0;              ///< about the pivot, from x towards y [N m/m in 2-D, N m]
};

/// Integrates the pressure over the facets of a wall: on each it is the linear fit of the fluid about its centre, where
/// positive, at the points of its quadrature, so that force and moment are exact on a hydrostatic field where the wall
/// is flat; a facet that the surface cuts is right to second order in l0. Facets with no fluid within 1.5 l0 are dry.
template <int D>
class WallLoad {
 public:
  /// @param pivot about which moments are [m]
  WallLoad(const SurfaceMesh& wall, const Eigen::Vector2d& pivot, double l0)
      : l0_(l0), pivot_(pivot), facets_(facets_of<D>(wall, l0)), loads_(facets_.size()) {}

  Load<D> read(const State<D>& s, const FluidCells<D>& cells) {
    const int size = static_cast<int>(facets_.size());
#pragma omp parallel for schedule(static)
    for (int k = 0; k < size; ++k) loads_[k] = is_wet(facets_[k], s, cells) ? on(facets_[k], s, cells) : Load<D>{};
    Load<D> sum;
    for (const Load<D>& load : loads_) {
      sum.force += load.force;
      sum.moment += load.moment;
    }
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
    const Eigen::Vector2d arm = facet.centre.template head<2>() - pivot_;
    Load<D> sum;
    for (const auto& [offset, area] : facet.points) {
      const Vec<D> force = std::max(0.0, fit.value + fit.slope.dot(offset)) * area;
      sum.force += force;
      sum.moment += (arm[0] + offset[0]) * force[1] - (arm[1] + offset[1]) * force[0];
    }
    return sum;
  }

  double l0_;
  Eigen::Vector2d pivot_;
  std::vector<Facet<D>> facets_;
  std::vector<Load<D>> loads_;
};

/// Force and moment on the walls.
template <int D>
class WallLoadSensor : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    if (!p.sensors.force) return {};
    const Scales scales(p);
    const auto force = [&](const char* name, const char* title, Rest rest) {
      return Column{name, D == 3 ? "N" : "N/m", title, ColumnKind::force, rest, scales.force};
    };
    std::vector<Column> all{force("force_x", "force x", Rest::zero), force("force_y", "force y", Rest::first_value)};
    if (D == 3) all.push_back(force("force_z", "force z", Rest::zero));
    all.push_back({"moment", D == 3 ? "N m" : "N m/m", "moment", ColumnKind::moment, Rest::first_value, scales.moment});
    return all;
  }

  explicit WallLoadSensor(const SensorSite<D>& site)
      : walls_(site.tank.surface(), {site.p.motion.pivot_x, site.p.motion.pivot_y}, site.p.particles.spacing) {}

  void read(const Instant<D>& now, Scalars& values) override {
    const Load<D> load = walls_.read(now.s, now.cells);
    values.insert(values.end(), load.force.begin(), load.force.end());
    values.push_back(load.moment);
  }

 private:
  WallLoad<D> walls_;
};

}  // namespace seiche::solver
