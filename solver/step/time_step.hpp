#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/parameters.hpp"

namespace seiche::solver {

/// Longest step that the rule allows at rest [s]: min(alpha l0/sqrt(g H), 0.2 l0^2/(d nu)). The paper has no cap; a
/// still tank needs one, and sqrt(g H) is the fastest wave on a depth H. The second is the stability limit of the
/// explicit viscous term with a margin (Morris, Fox, Zhu 1997). A step given by the scene stands for all of it.
/// @param wave_speed sqrt(g H) [m/s]
inline double step_cap(const Parameters& p, double wave_speed) {
  if (p.time.step > 0) return p.time.step;
  const double l0 = p.particles.spacing;
  const double by_wave = wave_speed > 0 ? p.time.courant * l0 / wave_speed : std::numeric_limits<double>::infinity();
  const double by_viscosity = p.fluid.viscosity > 0 ? 0.2 * l0 * l0 / (p.dimension() * p.fluid.viscosity) : by_wave;
  return std::min(by_wave, by_viscosity);
}

/// Equation (18), dt = alpha l0/v_max, with the cap above [s]; or the scene's own step, however fast the fluid.
inline double step_rule(const Parameters& p, double wave_speed, double fastest) {
  const double cap = step_cap(p, wave_speed);
  return fastest > 0 && p.time.step == 0 ? std::min(cap, p.time.courant * p.particles.spacing / fastest) : cap;
}

/// Splits what is left into equal steps no longer than the rule: the length of the next one [s]. The rule gives way by
/// a millionth, far more than the rounding of times, so that a whole number of steps stays one.
inline double split_evenly(double left, double longest) {
  return left / std::max(1.0, std::ceil(left / longest - 1e-6));
}

}  // namespace seiche::solver
