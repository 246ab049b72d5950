#include "solver/step/time_step.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

constexpr double wave = 2;  // [m/s]

Parameters water() {
  Parameters p;
  p.particles.spacing = 0.01;
  p.time.courant = 0.1;
  p.fluid.viscosity = 1e-6;
  return p;
}

TEST(TimeStep, OfFastFluidIsEquation18) {
  EXPECT_DOUBLE_EQ(step_rule(water(), wave, 5), 0.1 * 0.01 / 5);
  Parameters p = water();
  p.time.courant = 0.2;
  EXPECT_DOUBLE_EQ(step_rule(p, wave, 5), 0.2 * 0.01 / 5);
}

TEST(TimeStep, OfSlowFluidIsCappedByTheWave) {
  EXPECT_DOUBLE_EQ(step_cap(water(), wave), 0.1 * 0.01 / 2);
  for (double fastest : {0., 1e-9, 1., 1.999})
    EXPECT_DOUBLE_EQ(step_rule(water(), wave, fastest), 0.1 * 0.01 / 2) << fastest;
  EXPECT_LT(step_rule(water(), wave, 2.001), 0.1 * 0.01 / 2);
}

TEST(TimeStep, OfAStickyFluidIsCappedByViscosity) {
  Parameters p = water();
  p.fluid.viscosity = 0.1;
  EXPECT_DOUBLE_EQ(step_cap(p, wave), 0.2 * 0.01 * 0.01 / (2 * 0.1));
  p.tank.width = 0.3;
  EXPECT_DOUBLE_EQ(step_cap(p, wave), 0.2 * 0.01 * 0.01 / (3 * 0.1)) << "3-D";
  EXPECT_DOUBLE_EQ(step_rule(p, wave, 1), step_cap(p, wave));
}

TEST(TimeStep, HasACapWithoutViscosityOrGravity) {
  Parameters p = water();
  p.fluid.viscosity = 0;
  EXPECT_DOUBLE_EQ(step_cap(p, wave), 0.1 * 0.01 / 2);
  p = water();
  EXPECT_DOUBLE_EQ(step_cap(p, 0), 0.2 * 0.01 * 0.01 / (2 * 1e-6));
}

TEST(TimeStep, OfTheScenesOwnIsThatHoweverFastTheFluid) {
  Parameters p = water();
  p.time.step = 0.02;
  EXPECT_EQ(step_cap(p, wave), 0.02);
  for (double fastest : {0., 1., 50.}) EXPECT_EQ(step_rule(p, wave, fastest), 0.02) << fastest;
}

TEST(SplitEvenly, EndsExactlyInEqualSteps) {
  EXPECT_DOUBLE_EQ(split_evenly(1, 0.3), 0.25);
  EXPECT_DOUBLE_EQ(split_evenly(0.02, 0.5), 0.02);
  EXPECT_DOUBLE_EQ(split_evenly(1, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(split_evenly(0.3, 0.1), 0.1) << "0.3/0.1 rounds to less than 3, 0.1 * 3 to more than 0.3";
}

TEST(SplitEvenly, NeverExceedsTheRule) {
  for (double longest : {1e-5, 3.3e-4, 7.1e-3, 0.02, 1.}) {
    double time = 0;
    int steps = 0;
    const double until = 0.02, first = split_evenly(until, longest);
    while (time < until * (1 - 1e-12)) {
      const double dt = split_evenly(until - time, longest);
      EXPECT_LE(dt, longest * (1 + 1e-6));
      EXPECT_NEAR(dt, first, 1e-9 * first) << "the steps are equal";
      time += dt;
      ++steps;
    }
    EXPECT_NEAR(time, until, 1e-15 * steps);
    EXPECT_EQ(steps, std::ceil(until / longest));
  }
}

TEST(SplitEvenly, KeepsAWholeNumberOfStepsFarFromTheStart) {
  const double step = 2.5e-4;
  for (double start : {1., 100., 10000.}) {
    double time = start;
    for (int k = 0; k < 400; ++k) {
      const double dt = split_evenly(start + 0.1 - time, step);
      ASSERT_NEAR(dt, step, 1e-6 * step) << start << ", " << k;
      time += dt;
    }
    EXPECT_NEAR(time, start + 0.1, 1e-6 * step);
  }
}

}  // namespace
}  // namespace seiche::solver
