#include "solver/motion.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

constexpr double amplitude = 0.005, frequency = 1.25, omega = 2 * std::numbers::pi * frequency;
const Motion surge({.type = "surge", .amplitude = amplitude, .frequency = frequency});

TEST(Surge, StartsFromTheMiddleAtFullSpeed) {
  EXPECT_EQ(surge.displacement(0), 0);
  EXPECT_DOUBLE_EQ(surge.velocity(0), amplitude * omega);
  EXPECT_DOUBLE_EQ(surge.fastest(), amplitude * omega);
  EXPECT_NEAR(surge.displacement(0.25 / frequency), amplitude, 1e-17);
  EXPECT_NEAR(surge.velocity(0.25 / frequency), 0, 1e-16);
}

TEST(Surge, VelocityIsTheSlopeOfTheDisplacement) {
  constexpr double h = 1e-5;
  for (double t = 0; t < 2; t += 0.13)
    EXPECT_NEAR((surge.displacement(t + h) - surge.displacement(t - h)) / (2 * h), surge.velocity(t), 1e-9);
}

TEST(Surge, MeanAccelerationAddsUpToTheVelocityWhateverTheSteps) {
  double t = 0, velocity = surge.velocity(0);
  for (int step = 0; step < 500; ++step) {
    const double dt = step % 3 ? 1e-4 : 0.03;
    velocity += dt * surge.mean_acceleration(t, dt);
    t += dt;
    EXPECT_NEAR(velocity, surge.velocity(t), 1e-14);
  }
}

TEST(Surge, MeanAccelerationOfAShortStepIsTheAcceleration) {
  for (double t : {0.1, 0.2, 0.7})
    EXPECT_NEAR(surge.mean_acceleration(t - 5e-5, 1e-4), -omega * omega * surge.displacement(t), 1e-7);
}

TEST(Surge, PoseIsAlongTheTank) {
  const TankPose pose = surge.pose(0.1);
  EXPECT_EQ(pose.displacement, (Double3{surge.displacement(0.1), 0, 0}));
  EXPECT_EQ(pose.velocity, (Double3{surge.velocity(0.1), 0, 0}));
}

TEST(Surge, FastestIsNeverNegative) {
  EXPECT_GT(Motion({.type = "surge", .amplitude = -0.1, .frequency = 1, .start = "smooth"}).fastest(), 0);
}

TEST(Rest, IsWhateverElseIsGiven) {
  const Motion rest({.type = "none", .amplitude = amplitude, .frequency = frequency});
  EXPECT_EQ(rest.displacement(0.1), 0);
  EXPECT_EQ(rest.velocity(0.1), 0);
  EXPECT_EQ(rest.fastest(), 0);
  EXPECT_EQ(rest.mean_acceleration(0.1, 0.01), 0);
}

}  // namespace
}  // namespace seiche::solver
