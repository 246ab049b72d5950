#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/physics/runs.hpp"

namespace seiche::physics {
namespace {

long fluid(const Frame& frame) { return std::count(frame.kind.begin(), frame.kind.end(), Kind::fluid); }

// A tank jerked to the side at 2 m/s throws water over its rim.
TEST(OpenTank, TakesOutAndCountsWhatLeavesOverTheRim) {
  Parameters p = still_tank(0.3, 0.2, 0.22, 0.02);
  p.tank.closed = false;
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.3, 1.0}};
  const auto simulation = make_simulation(p, 0);
  const long before = fluid(*simulation->frame(0));
  while (simulation->time() < 0.6) simulation->step(0.6);
  const Statistics& totals = simulation->statistics();
  EXPECT_GT(totals.spilled, 0);
  EXPECT_EQ(fluid(*simulation->frame(1)), before - totals.spilled - totals.leaked);
  EXPECT_EQ(totals.fluid_particles, before - totals.spilled - totals.leaked);
}

// Velocity relative to the tank right after its velocity has jumped to U, by linear potential theory, which is exact
// for an impulse: u = -grad sum_n B_n cos(k_n x) cosh(k_n y)/cosh(k_n h), B_n = 4 L U/(n pi)^2, k_n = n pi/L, n odd.
std::array<double, 2> after_jump(double x, double y, double length, double depth, double jump) {
  std::array<double, 2> u{};
  for (int n = 1; n <= 99; n += 2) {
    const double k = n * M_PI / length, b = 4 * length * jump / std::pow(n * M_PI, 2);
    const double decay = std::exp(k * (y - depth)) / (1 + std::exp(-2 * k * depth));
    u[0] -= b * k * std::sin(k * x) * decay * (1 + std::exp(-2 * k * y));
    u[1] += b * k * std::cos(k * x) * decay * (1 - std::exp(-2 * k * y));
  }
  return u;
}

double start_error(double spacing) {
  const Parameters p = pan2008(Preset::stabilised, spacing);
  const double jump = p.motion.harmonic.amplitude * 2 * M_PI * p.motion.harmonic.frequency;
  const auto frame = make_simulation(p, 0)->frame(0);
  double sum = 0;
  for (std::size_t i = 0; i < frame->size(); ++i) {
    if (frame->kind[i] != Kind::fluid) continue;
    const auto& r = frame->position[i];
    const auto u = after_jump(r[0], r[1], p.tank.length, p.fluid.depth, jump);
    sum += std::pow(frame->velocity[i][0] - u[0], 2) + std::pow(frame->velocity[i][1] - u[1], 2);
  }
  return std::sqrt(sum / static_cast<double>(fluid(*frame))) / jump;
}

TEST(Start, ImpulsiveConvergesToPotentialTheory) {
  const double coarse = start_error(0.02), fine = start_error(0.01);
  EXPECT_LT(fine, 0.1);
  EXPECT_GT(std::log2(coarse / fine), 0.5);  // The velocity has a logarithmic singularity in the upper corners.
}

TEST(Start, SmoothLeavesTheWaterAtRestInTheTank) {
  Parameters p = pan2008(Preset::stabilised, 0.02);
  p.motion.start = Start::smooth;
  EXPECT_EQ(fastest(*make_simulation(p, 0)->frame(0)), 0);
}

}  // namespace
}  // namespace seiche::physics
