#include "solver/motion/body_force.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

constexpr double g = 9.81;

Motion moving(bool rolling) {
  Parameters::Motion m{.type = "harmonics"};
  m.harmonics = {{"surge", 0.05, 1.1, 20}, {"heave", 0.03, 0.6, 0}};
  if (rolling) m.harmonics.push_back({"roll", 15, 0.8, 40});
  m.pivot_x = 0.3;
  m.pivot_y = -0.1;
  return Motion(m);
}

/// Position in the tank's frame of a body that is thrown from `at` at `velocity` in the lab and falls freely, and its
/// velocity relative to the tank, from the rule for the pose alone.
struct Thrown {
  Vec<2> at{0.1, 0.2}, velocity{0.4, 1.5};

  Vec<2> position(const Motion& motion, double t) const {
    const TankPose pose = motion.pose(t);
    const Vec<2> pivot(pose.pivot[0], pose.pivot[1]), moved(pose.displacement[0], pose.displacement[1]);
    const Vec<2> lab = at + t * velocity - 0.5 * g * t * t * Vec<2>::Unit(1);
    return pivot + Eigen::Rotation2Dd(-pose.roll) * (lab - pivot - moved);
  }
  Vec<2> speed(const Motion& motion, double t) const {
    constexpr double h = 1e-5;
    return (position(motion, t + h) - position(motion, t - h)) / (2 * h);
  }
};

/// Distance, after 0.5 s in so many steps, from where it is by the body force to where it is.
double error_of_flight(const Motion& motion, int steps) {
  const Thrown thrown;
  const double dt = 0.5 / steps;
  Vec<2> r = thrown.position(motion, 0), u = thrown.speed(motion, 0);
  for (int k = 0; k < steps; ++k) {
    const Vec<2> old = u;
    u += dt * body_force<2>(motion, g, k * dt, dt)(r, u);
    r += 0.5 * dt * (old + u);
  }
  return (r - thrown.position(motion, 0.5)).norm();
}

TEST(BodyForce, CarriesAFreeBodyAlongItsParabolaToFirstOrderInARollingTank) {
  const Motion motion = moving(true);
  const double coarse = error_of_flight(motion, 100), fine = error_of_flight(motion, 200);
  EXPECT_LT(fine, 0.005);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.15);
  EXPECT_LT(error_of_flight(motion, 20000), 1e-4) << "to where the body is, and nowhere else";
}

TEST(BodyForce, GivesAFreeBodyItsExactVelocityInATankThatOnlyTranslates) {
  const Motion motion = moving(false);
  const Thrown thrown;
  Vec<2> u = thrown.speed(motion, 0);
  double t = 0;
  for (int k = 0; k < 50; ++k) {
    const double dt = k % 3 ? 1e-4 : 0.03;
    u += dt * body_force<2>(motion, g, t, dt)(Vec<2>::Zero(), u);
    t += dt;
    EXPECT_LT((u - thrown.speed(motion, t)).norm(), 1e-8);
  }
}

TEST(BodyForce, OfCoriolisKeepsTheSpeedWhateverTheStep) {
  Parameters::Motion m{.type = "roll", .amplitude = 90, .frequency = 1};
  const auto force = body_force<2>(Motion(m), 0, 0, 0.01);
  const Vec<2> pivot = Vec<2>::Zero(), u(0.3, -1.2);
  EXPECT_NEAR((u + 0.01 * (force(pivot, u) - force(pivot, Vec<2>::Zero()))).norm(), u.norm(), 1e-14);
}

TEST(BodyForce, ActsInThePlaneOfTheRoll) {
  const Motion motion = moving(true);
  const Vec<3> r(0.5, 0.2, 0.7), u(1, 2, 3);
  const auto flat = body_force<2>(motion, g, 0.1, 1e-3)(r.head<2>(), u.head<2>());
  const auto force = body_force<3>(motion, g, 0.1, 1e-3)(r, u);
  EXPECT_EQ(force.head<2>(), flat);
  EXPECT_EQ(force[2], 0);
}

TEST(BodyForce, KnowsItsDivergenceOverLiquidAtRestInTheLab) {
  Parameters::Motion m{.type = "roll", .amplitude = 30, .frequency = 1, .phase = 20};
  const Motion motion(m);
  constexpr double t = 0.1, dt = 1e-6, h = 1e-3;
  const auto force = body_force<2>(motion, g, t, dt);
  const double rate = motion.roll(t).rate;
  const auto at = [&](double x, double y) { return force({x, y}, {rate * y, -rate * x}); };
  const double divergence = (at(h, 0)[0] - at(-h, 0)[0] + at(0, h)[1] - at(0, -h)[1]) / (2 * h);
  EXPECT_NEAR(force.divergence, divergence, 1e-4 * rate * rate);
  EXPECT_NEAR(force.divergence, -2 * rate * rate, 1e-4 * rate * rate);
}

TEST(StartForce, GivesLiquidAtRestInTheLabItsVelocityInTheTank) {
  const Motion motion = moving(true);
  const Thrown rest{{0.2, 0.15}, {0, 0}};
  const Vec<2> r = rest.position(motion, 0);
  EXPECT_LT((0.01 * start_force<2>(motion, 0.01)(r, Vec<2>::Zero()) - rest.speed(motion, 0)).norm(), 1e-8);
}

}  // namespace
}  // namespace seiche::solver
