#include "solver/motion/wave_speed.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace seiche::solver {
namespace {

const Bounds<2> tank{{0, 0}, {0.4, 0.3}};
const double turn = 2 * std::numbers::pi;

TEST(WaveSpeed, IsThatOfALongWave) {
  Parameters p;
  p.gravity = 8;
  p.fluid.depth = 0.5;
  EXPECT_DOUBLE_EQ(wave_speed(p, tank, Motion(p.motion)), 2);
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.01, 1}};
  EXPECT_DOUBLE_EQ(wave_speed(p, tank, Motion(p.motion)), 2) << "0.4 m/s^2 are less than gravity";
}

TEST(WaveSpeed, WithoutGravityIsThatOfTheMotion) {
  Parameters p;
  p.gravity = 0;
  p.fluid.depth = 0.5;
  EXPECT_EQ(wave_speed(p, tank, Motion(p.motion)), 0);
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::heave, -0.02, 3}};
  EXPECT_DOUBLE_EQ(greatest_pull(p, tank, Motion(p.motion)), 0.02 * 9 * turn * turn);
  EXPECT_DOUBLE_EQ(wave_speed(p, tank, Motion(p.motion)), std::sqrt(0.02 * 9 * turn * turn * 0.5));
}

TEST(WaveSpeed, OfARotationIsThatOfTheFarthestCorner) {
  Parameters p;
  p.gravity = 0;
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 90, 1}, .pivot_x = 0.1};
  const double angle = std::numbers::pi / 2, reach = std::hypot(0.3, 0.3);
  EXPECT_DOUBLE_EQ(reach_of(tank, p.motion), reach);
  const double alpha = angle * turn * turn, omega = angle * turn;
  EXPECT_NEAR(greatest_pull(p, tank, Motion(p.motion)), reach * (alpha + omega * omega), 1e-9);
}

}  // namespace
}  // namespace seiche::solver
