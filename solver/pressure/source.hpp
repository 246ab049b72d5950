#pragma once
#include <variant>

#include "solver/parameters.hpp"

// The source of the pressure equation, its right-hand side over -1: rho times the rate at which the density must fall
// [kg/(m^3 s^2)].
namespace seiche::solver {

/// (rho/dt^2) (n - n0)/n0, equation (10).
struct DensitySource {
  double density;  ///< rho [kg/m^3]

  explicit DensitySource(const Parameters& p) : density(p.fluid.density) {}

  /// @param excess of number density, (n - n0)/n0
  double operator()(double excess, double dt) const { return density * excess / (dt * dt); }
};

/// (rho/dt) (-div u* + rate e), e the excess of particles (volume.hpp) (after Tanaka & Masunaga 2010). They write
/// gamma/dt for the rate and n for the measure; a rate that doesn't change with dt keeps the two terms in balance when
/// it does, else each change is a pressure spike. 0.1 sqrt(g H)/l0 is their gamma of 0.02 at the longest step of
/// alpha = 0.2. Near the free surface, where neighbours lack, e < 0 means nothing and is dropped.
struct MixedSource {
  double density;  ///< rho [kg/m^3]
  double rate;     ///< [1/s]

  /// @param wave_speed sqrt(g H) [m/s]
  MixedSource(const Parameters& p, double wave_speed)
      : density(p.fluid.density), rate(0.1 * wave_speed / p.particles.spacing) {}

  /// @param divergence of u* [1/s]
  double operator()(double divergence, double excess, bool near_surface, double dt) const {
    if (near_surface && excess < 0) excess = 0;
    return density / dt * (-divergence + rate * excess);
  }
};

using Source = std::variant<DensitySource, MixedSource>;

inline Source make_source(const Parameters& p, double wave_speed) {
  if (p.method.source == SourceTerm::density) return DensitySource(p);
  return MixedSource(p, wave_speed);
}

}  // namespace seiche::solver
