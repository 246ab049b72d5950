#pragma once
#include <cmath>
#include <numbers>

#include "solver/frame.hpp"
#include "solver/parameters.hpp"

namespace seiche::solver {

/// The tank's motion in the lab: surge x(t) = A sin(2 pi f t), or rest.
class Motion {
 public:
  explicit Motion(const Parameters::Motion& m)
      : amplitude_(m.type == "surge" ? m.amplitude : 0), omega_(2 * std::numbers::pi * m.frequency) {}

  double displacement(double t) const { return amplitude_ * std::sin(omega_ * t); }       ///< [m]
  double velocity(double t) const { return amplitude_ * omega_ * std::cos(omega_ * t); }  ///< [m/s]
  double fastest() const { return std::abs(amplitude_ * omega_); }                        ///< [m/s]

  /// Mean acceleration over a step [m/s^2]: with it the velocity of a free particle is exact whatever the step.
  double mean_acceleration(double t, double dt) const { return (velocity(t + dt) - velocity(t)) / dt; }

  TankPose pose(double t) const { return {{displacement(t), 0, 0}, {velocity(t), 0, 0}}; }

 private:
  double amplitude_, omega_;
};

}  // namespace seiche::solver
