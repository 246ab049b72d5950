#pragma once
#include <cmath>

#include "solver/parameters.hpp"
#include "solver/tank/level.hpp"
#include "solver/tank/level_axes.hpp"

namespace seiche::solver {

/// By how much readings are expected to change: a share of what the still liquid has, and 1 where that is nothing.
struct Scales {
  double pressure = 0;  ///< a quarter of rho g h [Pa]
  double length = 0;    ///< a quarter of the depth h [m]
  double volume = 0;    ///< a hundredth [m^2 in 2-D, m^3]
  double force = 0;     ///< a tenth of the weight [N/m, N]
  double moment = 0;    ///< that times the tank's length [N m/m, N m]
  double energy = 0;    ///< a hundredth of the weight times h [J/m, J]
  double swirl = 0;     ///< what a wave of that energy has that goes round at sqrt(g/length of the tank) [kg m^2/s]

  explicit Scales(const Parameters& p) {
    const double depth = p.fluid.depth, specific = p.fluid.density * p.gravity.size();
    const SurfaceMesh wall = on_level_axes(wall_surface(p), p.gravity);
    const double length_of_tank = wall.size()[0], all = volume_below(wall, wall.low()[1] + depth);
    pressure = or_one(0.25 * specific * depth);
    length = or_one(0.25 * depth);
    volume = or_one(0.01 * all);
    force = or_one(0.1 * specific * all);
    moment = or_one(0.1 * specific * all * length_of_tank);
    energy = or_one(0.01 * specific * all * depth);
    swirl = or_one(0.01 * p.fluid.density * all * depth * std::sqrt(p.gravity.size() * length_of_tank));
  }

 private:
  static double or_one(double scale) { return scale > 0 ? scale : 1; }
};

}  // namespace seiche::solver
