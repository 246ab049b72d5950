#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "solver/make_simulation.hpp"
#include "solver/preset.hpp"

namespace seiche::physics {

/// The tank of Pan, Zhang and Lu (2008): 0.6 m x 0.2 m of water, surge of 5 mm at 1 Hz, impulsive start.
inline Parameters pan2008(Preset preset, double spacing) {
  Parameters p;
  apply_preset(p, preset);
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.005, 1.0}};
  p.particles.spacing = spacing;
  return p;
}

inline Parameters still_tank(double length, double depth, double height, double spacing) {
  Parameters p;
  p.tank.length = length;
  p.tank.height = height;
  p.fluid.depth = depth;
  p.particles.spacing = spacing;
  return p;
}

/// Steps to `end` with a frame every `interval`, which `look` sees.
inline void run(Simulation& simulation, double interval, double end, const std::function<void(const Frame&)>& look) {
  const long frames = std::lround(end / interval);
  for (long k = 0; k <= frames; ++k) {
    const double next = static_cast<double>(k) * interval;
    while (simulation.time() < next) simulation.step(next);
    look(*simulation.frame(k));
  }
}

/// Root mean square over the fluid of p - rho g d, over rho g depth [-], d the depth below the level at a place [m].
inline double hydrostatic_error(const Frame& frame, const Parameters& p,
                                const std::function<double(const Float3&)>& depth_at) {
  const double weight = p.fluid.density * p.gravity.size();
  double sum = 0;
  long n = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.kind[i] != Kind::fluid) continue;
    const double error = frame.pressure[i] - weight * depth_at(frame.position[i]);
    sum += error * error;
    ++n;
  }
  return std::sqrt(sum / static_cast<double>(n)) / (weight * p.fluid.depth);
}

/// The same in an upright tank.
inline double hydrostatic_error(const Frame& frame, const Parameters& p) {
  return hydrostatic_error(frame, p, [&](const Float3& r) { return p.fluid.depth - r[1]; });
}

/// Of the water's centre of mass: x [m].
inline double centre(const Frame& frame) {
  double sum = 0;
  long n = 0;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) sum += frame.position[i][0], ++n;
  return sum / static_cast<double>(n);
}

inline double fastest(const Frame& frame) {
  double v2 = 0;
  for (const Float3& v : frame.velocity)
    v2 = std::max(v2, static_cast<double>(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  return std::sqrt(v2);
}

}  // namespace seiche::physics
