#pragma once
#include <cmath>
#include <numbers>

#include "solver/parameters.hpp"
#include "solver/particles/vec.hpp"

namespace seiche::solver::modes {

/// The linear standing wave of a tank, as it is when its surface passes through flat (H. Lamb, Hydrodynamics, 6th ed.,
/// 1932, art. 228 and 257):
///   phi = A g/omega cosh(k y)/cosh(k h) cos(k x),  k = n pi/L,  omega^2 = g k tanh(k h),
/// A the amplitude of the elevation A cos(k x) sin(omega t), n the number of half waves along the tank.
struct StandingWave {
  double speed;       ///< A g k/omega [m/s]
  double wavenumber;  ///< k [1/m]
  double depth;       ///< h [m]

  /// @param length of the tank, with upright ends at x = 0 and there [m]
  StandingWave(const Parameters& p, double length)
      : wavenumber(p.fluid.wave_mode * std::numbers::pi / length), depth(p.fluid.depth) {
    const double omega = std::sqrt(p.gravity.size() * wavenumber * std::tanh(wavenumber * depth));
    speed = p.fluid.wave_amplitude * p.gravity.size() * wavenumber / omega;
  }

  /// grad phi at r [m/s]; none across a wall or through the floor.
  template <int D>
  Vec<D> velocity(const Vec<D>& r) const {
    Vec<D> u = Vec<D>::Zero();
    u[0] = -speed * std::cosh(wavenumber * r[1]) / std::cosh(wavenumber * depth) * std::sin(wavenumber * r[0]);
    u[1] = speed * std::sinh(wavenumber * r[1]) / std::cosh(wavenumber * depth) * std::cos(wavenumber * r[0]);
    return u;
  }
};

}  // namespace seiche::solver::modes
