#include "solver/modes/standing_wave.hpp"

#include <gtest/gtest.h>

#include "solver/make_simulation.hpp"

namespace seiche::solver {
namespace {

Parameters tank_with_wave(int mode) {
  Parameters p;
  p.particles.spacing = 0.01;
  p.fluid.wave_amplitude = 0.004;
  p.fluid.wave_mode = mode;
  return p;
}

TEST(StandingWave, HasTheElevationsAmplitude) {
  // k = pi/0.6, omega^2 = 9.81 k tanh(0.2 k), omega = 6.3325688/s (1.00786 Hz): the surface rises at A omega at the
  // left wall.
  const modes::StandingWave wave(tank_with_wave(1), tank_with_wave(1).tank.length);
  EXPECT_NEAR(wave.velocity<2>({0, 0.2})[1], 0.004 * 6.3325688, 1e-7);
  EXPECT_NEAR(wave.velocity<2>({0.6, 0.2})[1], -0.004 * 6.3325688, 1e-7);
  // Half way along the tank and up: u = -A g k/omega cosh(k h/2)/cosh(k h).
  EXPECT_NEAR(wave.velocity<2>({0.3, 0.1})[0], -0.004 * 9.81 * 5.2359878 / 6.3325688 * 1.1402383 / 1.6002869, 1e-7);
}

TEST(StandingWave, FlowsAlongWallsAndFloorAndHasNoDivergence) {
  for (const int mode : {1, 2, 5}) {
    const modes::StandingWave wave(tank_with_wave(mode), tank_with_wave(mode).tank.length);
    for (const double s : {0.01, 0.07, 0.13, 0.19}) {
      EXPECT_NEAR(wave.velocity<2>({0, s})[0], 0, 1e-15);
      EXPECT_NEAR(wave.velocity<2>({0.6, s})[0], 0, 1e-15);
      EXPECT_NEAR(wave.velocity<2>({3 * s, 0})[1], 0, 1e-15);
      const double d = 1e-5;
      const auto u = [&](double dx, double dy) { return wave.velocity<2>({3 * s + dx, s + dy}); };
      const double divergence = (u(d, 0)[0] - u(-d, 0)[0] + u(0, d)[1] - u(0, -d)[1]) / (2 * d);
      EXPECT_NEAR(divergence, 0, 1e-8 * wave.speed * wave.wavenumber * mode);
    }
  }
}

TEST(StandingWave, IsWhatASimulationStartsWith) {
  for (const double width : {0.0, 0.04}) {
    Parameters p = tank_with_wave(2);
    p.tank.width = width;
    const FramePtr frame = make_simulation(p, 0)->frame(0);
    const modes::StandingWave wave(p, p.tank.length);
    for (std::size_t i = 0; i < frame->size(); ++i) {
      const auto& [x, y, z] = frame->position[i];
      const Vec<2> u = frame->kind[i] == Kind::fluid ? wave.velocity<2>({x, y}) : Vec<2>(0, 0);
      ASSERT_NEAR(frame->velocity[i][0], u[0], 1e-7);
      ASSERT_NEAR(frame->velocity[i][1], u[1], 1e-7);
      ASSERT_EQ(frame->velocity[i][2], 0);
    }
  }
}

}  // namespace
}  // namespace seiche::solver
