#pragma once
#include "solver/parameters.hpp"

namespace seiche::solver {

/// Share of the full neighbour count under which a particle may be at the free surface (Tanaka & Masunaga 2010).
inline constexpr double count_share = 0.85;

/// Added to the diagonal of the pressure equation, in units of n0: keeps the matrix definite where a clump of particles
/// touches no free surface, and is far below the discretisation error everywhere else.
inline constexpr double definite = 1e-7;

/// Right-hand side of the pressure equation over -1, that is rho times the rate at which density must fall [kg/(m^3
/// s^2)].
///  density: (rho/dt^2) (n - n0)/n0, equation (10);
///  mixed:   rho (-div u*/dt + (gamma/dt^2) (n - n0)/n0) with gamma = 0.02 (Tanaka & Masunaga 2010), and a
///  compressibility
///           C = 0.001 gamma/(rho g H) on the diagonal, so that the over-density at the bottom of a still tank of depth
///           H is a thousandth. Near the free surface, where neighbours lack, n < n0 means nothing and is dropped.
struct Source {
  static constexpr double gamma = 0.02;
  bool mixed;
  double compressibility;  ///< rho C/dt^2, on the diagonal [1/m^2]

  Source(const Parameters& p, double dt)
      : mixed(p.method.source == "mixed"),
        compressibility(mixed && p.gravity > 0 ? 0.001 * gamma / (p.gravity * p.fluid.depth * dt * dt) : 0),
        density_(p.fluid.density),
        dt_(dt) {}

  double operator()(double divergence, double excess, bool near_surface) const {
    if (!mixed) return density_ * excess / (dt_ * dt_);
    if (near_surface && excess < 0) excess = 0;
    return density_ * (-divergence / dt_ + gamma * excess / (dt_ * dt_));
  }

 private:
  double density_, dt_;
};

}  // namespace seiche::solver
