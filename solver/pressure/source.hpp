#pragma once
#include <cmath>

#include "solver/parameters.hpp"

namespace seiche::solver {

/// Share of the full neighbour count up to which a particle may be at the free surface (Tanaka & Masunaga 2010).
inline constexpr double count_share = 0.85;

/// Added to the diagonal of the pressure equation, in units of n0: keeps the matrix definite where a clump of particles
/// touches no free surface, and is far below the discretisation error everywhere else.
inline constexpr double definite = 1e-7;

/// Right-hand side of the pressure equation over -1: rho times the rate at which the density must fall [kg/(m^3 s^2)].
///  density: (rho/dt^2) (n - n0)/n0, equation (10);
///  mixed:   (rho/dt) (-div u* + rate e), e the excess of particles (volume.hpp) (after Tanaka & Masunaga 2010). They
///           write gamma/dt for the rate and n for the measure; a rate that doesn't change with dt keeps the two terms
///           in balance when it does, else each change is a pressure spike. 0.1 sqrt(g H)/l0 is their gamma of 0.02 at
///           the longest step of alpha = 0.2. Near the free surface, where neighbours lack, e < 0 means nothing and is
///           dropped.
struct Source {
  bool mixed;
  double density;  ///< rho [kg/m^3]
  double rate;     ///< [1/s]
  double dt;       ///< [s]

  Source(const Parameters& p, double step)
      : mixed(p.method.source == SourceTerm::mixed),
        density(p.fluid.density),
        rate(0.1 * std::sqrt(p.gravity * p.fluid.depth) / p.particles.spacing),
        dt(step) {}

  double operator()(double divergence, double excess, bool near_surface) const {
    if (!mixed) return density * excess / (dt * dt);
    if (near_surface && excess < 0) excess = 0;
    return density / dt * (-divergence + rate * excess);
  }
};

}  // namespace seiche::solver
