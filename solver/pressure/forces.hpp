#pragma once
#include "solver/particles/each_fluid.hpp"
#include "solver/particles/kept.hpp"

namespace seiche::solver {

/// What acts on each fluid particle in a step, the pressure apart.
template <int D>
struct Forces {
  Vecs<D> body;           ///< f [m/s^2]
  Vecs<D> slope;          ///< rho f, the slope of the pressure that would balance it [Pa/m]
  double divergence = 0;  ///< of f [1/s^2]
  Vecs<D> viscous;        ///< nu Laplacian(u) [m/s^2]

  /// Sets f, its slope and its divergence.
  /// @param force has f as a function of position and velocity, and its divergence
  /// @param rho of the liquid [kg/m^3]
  template <class Force>
  void set_body(const Force& force, double rho, const State<D>& s) {
    resize_kept(body, s.size());
    resize_kept(slope, s.size());
    divergence = force.divergence;
    each_fluid(s, [&](int i) {
      body[i] = force(s.position[i], s.velocity[i]);
      slope[i] = rho * body[i];
    });
  }
};

}  // namespace seiche::solver
