#include <gtest/gtest.h>

#include <algorithm>

#include "tests/physics/runs.hpp"

namespace seiche::physics {
namespace {

// The walls are all that moves the water sideways, so the momentum that they take from it over some time is what the
// water has lost in the lab; and in the mean they carry its weight.
TEST(WallForce, BalancesTheMomentumOfTheWater) {
  const Parameters p = pan2008(Preset::stabilised, 0.01);
  const auto simulation = make_simulation(p, 0.001);
  const std::size_t columns = sensor_columns(p).size(), fx = find_column(sensor_columns(p), "force_x"), fy = fx + 1;
  const double mass = p.fluid.density * p.tank.length * p.fluid.depth, w = 2 * M_PI * p.motion.harmonic.frequency;
  const auto momentum = [&](const Frame& frame) {
    double sum = 0;
    long n = 0;
    for (std::size_t i = 0; i < frame.size(); ++i)
      if (frame.kind[i] == Kind::fluid) sum += frame.velocity[i][0], ++n;
    return mass * (sum / static_cast<double>(n) + p.motion.harmonic.amplitude * w * std::cos(w * frame.time));
  };
  // From 0.05 s on, when the first steps after the impulsive start are over.
  double impulse = 0, last = 0, start = 0, error = 0, greatest = 0, weight = 0;
  long samples = 0;
  run(*simulation, 0.05, 0.6, [&](const Frame& frame) {
    for (std::size_t k = 0; k < frame.readings.time.size(); ++k) {
      const double* row = &frame.readings.values[columns * k];
      if (frame.readings.time[k] > 0.0505) {
        impulse += 0.001 * 0.5 * (last + row[fx]);
        weight += row[fy];
        ++samples;
      }
      last = row[fx];
    }
    if (frame.index == 1) start = momentum(frame);
    if (frame.index < 1) return;
    error = std::max(error, std::abs(momentum(frame) - start + impulse));
    greatest = std::max(greatest, std::abs(momentum(frame) - start));
  });
  EXPECT_LT(error, 0.03 * greatest) << error << " of " << greatest << " N s/m";
  EXPECT_NEAR(weight / static_cast<double>(samples), -mass * p.gravity.size(), 0.005 * mass * p.gravity.size());
}

}  // namespace
}  // namespace seiche::physics
