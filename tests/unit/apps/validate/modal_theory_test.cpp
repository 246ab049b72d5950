#include "apps/validate/modal_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace seiche::apps::validate {
namespace {

Parameters rolling(double degrees, double frequency) {
  Parameters p;  // 0.6 m x 0.2 m of water
  p.motion.type = MotionType::harmonic;
  p.motion.harmonic.of = DegreeOfFreedom::roll;
  p.motion.harmonic.amplitude = degrees;
  p.motion.harmonic.frequency = frequency;
  p.motion.pivot_x = 0.3;
  return p;
}

TEST(NaturalFrequency, OfThePapersTank) {
  EXPECT_NEAR(natural_frequency(Parameters{}, 1) / (2 * std::numbers::pi), 1.00786, 1e-5);
}

TEST(RollTheory, KeepsTheSurfaceLevelWhereTheTankTurnsSlowly) {
  // A quarter period of 1000 s: the surface is horizontal, hence lower by tan(theta) L/2 at the side that went up.
  const Series left = roll_elevation(rolling(0.5, 0.001), 1, 250);
  EXPECT_NEAR(left.y.back(), 0.3 * 0.5 * std::numbers::pi / 180, 3e-5);
}

// About a pivot a kilometre below, a roll of -A/1000 m shakes the tank by A; the elevations of a surge of 5 mm at 1 Hz
// by linear modal theory, from an independent program, at 0.5, 1 and 2 s.
TEST(RollTheory, IsThatOfASurgeForAPivotFarBelow) {
  constexpr double radius = 1000;
  Parameters p = rolling(-0.005 / radius * 180 / std::numbers::pi, 1);
  p.motion.pivot_y = -radius;
  const Series left = roll_elevation(p, 0.01, 2);
  EXPECT_NEAR(left.at(0.5), -0.007573, 3e-5);
  EXPECT_NEAR(left.at(1), 0.015308, 3e-5);
  EXPECT_NEAR(left.at(2), 0.031040, 3e-5);
}

// A surface that is a lid at t = 0+ would rise with the floor; it is at Phi = 0 instead. About the floor's middle the
// elevation's first mode then starts at -(omega^2/g) c (h - 2 tanh(k h/2)/k) theta'.
TEST(RollTheory, StartsImpulsively) {
  Parameters p = rolling(0.5, 0.8);
  p.fluid.depth = 0.02;  // shallow: h - 2 tanh(k h/2)/k is next to nothing, and the water stays where it is
  const Series shallow = roll_elevation(p, 0.001, 0.01);
  const double wall_rises = 0.3 * 0.5 * std::numbers::pi / 180 * std::sin(2 * std::numbers::pi * 0.8 * 0.01);
  EXPECT_LT(std::abs(shallow.y.back()), 0.1 * wall_rises);
}

TEST(RollTheory, RefusesOtherMotions) {
  Parameters p = rolling(0.5, 0.8);
  p.motion.type = MotionType::harmonic;
  p.motion.harmonic.of = DegreeOfFreedom::surge;
  EXPECT_THROW(roll_elevation(p, 0.01, 1), std::invalid_argument);
  p = rolling(0.5, 0.8);
  p.motion.start = Start::smooth;
  EXPECT_THROW(roll_elevation(p, 0.01, 1), std::invalid_argument);
}

}  // namespace
}  // namespace seiche::apps::validate
