#pragma once
#include <array>
#include <cmath>

#include "solver/sensors/pressure_fit.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"

namespace seiche::solver {

/// What the liquid does to the walls.
template <int D>
struct Load {
  Vec<D> force = Vec<D>::Zero();  ///< integral of p n over the walls, in the tank's axes [N/m in 2-D, N]
  double moment = 0;              ///< about the pivot, from x towards y [N m/m in 2-D, N m]
};

/// Integrates the pressure over the walls: each wall particle stands for a square of l0 of wall, l0/2 in front of it.
/// There the pressure is the linear fit of the fluid, where positive, at 4 points along each axis, placed such that
/// force and moment are exact on a hydrostatic field; a square that the surface cuts is right to second order in l0.
/// Squares with no fluid within 1.5 l0 are dry.
template <int D>
class WallLoad {
 public:
  WallLoad(const Parameters& p, const State<D>& s) : l0_(p.particles.spacing) {
    pivot_ << p.motion.pivot_x, p.motion.pivot_y;
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.kind[i] == Kind::wall && s.normal[i].squaredNorm() > 0)
        squares_.push_back({s.position[i] - 0.5 * l0_ * s.normal[i], s.normal[i]});
    loads_.resize(squares_.size());
  }

  Load<D> read(const State<D>& s, const FluidCells<D>& cells) {
    const int size = static_cast<int>(squares_.size());
#pragma omp parallel for schedule(static)
    for (int k = 0; k < size; ++k)
      loads_[k] = is_wet(squares_[k].centre, cells) ? on(squares_[k], s, cells) : Load<D>{};
    Load<D> sum;
    for (const Load<D>& load : loads_) {
      sum.force += load.force;
      sum.moment += load.moment;
    }
    return sum;
  }

 private:
  struct Square {
    Vec<D> centre, normal;
  };

  bool is_wet(const Vec<D>& centre, const FluidCells<D>& cells) const {
    bool wet = false;
    cells.near(centre, [&](int, const Vec<D>& offset) { wet |= offset.norm() < 1.5 * l0_; });
    return wet;
  }

  Load<D> on(const Square& square, const State<D>& s, const FluidCells<D>& cells) const {
    const LinearPressure<D> fit = fit_pressure(square.centre, l0_, s, cells);
    // Gauss points of both halves of [-1/2, 1/2]: exact up to cubics, and fine enough for a cut square.
    const double g = 1 / std::sqrt(48);
    const std::array<double, 4> at{-0.25 - g, -0.25 + g, 0.25 - g, 0.25 + g};
    Eigen::Index wall;
    square.normal.cwiseAbs().maxCoeff(&wall);
    constexpr int points = D == 3 ? 16 : 4;
    Load<D> sum;
    for (int k = 0; k < points; ++k) {
      Vec<D> offset = Vec<D>::Zero();
      offset[(wall + 1) % D] = at[k % 4] * l0_;
      if (D == 3) offset[(wall + 2) % D] = at[k / 4] * l0_;
      const double pressure = std::max(0.0, fit.value + fit.slope.dot(offset));
      const Vec<D> force = pressure * std::pow(l0_, D - 1) / points * square.normal;
      const Eigen::Vector2d arm = (square.centre + offset).template head<2>() - pivot_;
      sum.force += force;
      sum.moment += arm[0] * force[1] - arm[1] * force[0];
    }
    return sum;
  }

  double l0_;
  Eigen::Vector2d pivot_;
  std::vector<Square> squares_;
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

  WallLoadSensor(const Parameters& p, const State<D>& start) : walls_(p, start) {}

  void read(const Instant<D>& now, Scalars& values) override {
    const Load<D> load = walls_.read(now.s, now.cells);
    values.insert(values.end(), load.force.begin(), load.force.end());
    values.push_back(load.moment);
  }

 private:
  WallLoad<D> walls_;
};

}  // namespace seiche::solver
