#pragma once
#include "solver/frame.hpp"
#include "solver/parameters.hpp"
#include "solver/tank/level_axes.hpp"

// What a frame of liquid at rest ought to be: still, at the pressure p = rho g (level - height).
namespace seiche::apps::validate {

/// The pressure of a tank's liquid at rest.
class StillPressure {
 public:
  explicit StillPressure(const Parameters& p);

  /// Root mean square over the fluid of what its pressure differs from that by, over rho g depth [-]. Of chambers with
  /// levels of their own each particle has that of the seed nearest to it.
  double error(const Frame& frame) const;

 private:
  double at(const Float3& place) const;

  Parameters p_;
  solver::LevelAxes<3> axes_;
  double bottom_;  ///< height of the tank's lowest point along them [m]
};

/// Greatest speed [m/s].
double greatest_speed(const Frame& frame);

/// Root mean square of the fluid's speeds [m/s].
double rms_speed(const Frame& frame);

}  // namespace seiche::apps::validate
