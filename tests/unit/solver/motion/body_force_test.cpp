#include "solver/motion/body_force.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

constexpr double g = 9.81;

Motion moving(bool rolling) {
  Parameters::Motion m{.type = MotionType::harmonics};
  m.harmonics = {{DegreeOfFreedom::surge, 0.05, 1.1, 20}, {DegreeOfFreedom::heave, 0.03, 0.6, 0}};
  if (rolling) m.harmonics.push_back({DegreeOfFreedom::roll, 15, 0.8, 40});
  m.pivot_x = 0.3;
  m.pivot_y = -0.1;
  return Motion(m);
}

/// Position in the tank's frame of a body that is thrown from `at` at `velocity` in the lab and falls freely, and its
/// velocity relative to the tank, from the rule for the pose alone.
template <int D>
struct Thrown {
  Vec<D> at, velocity;
  double gravity = g;

  Vec<D> position(const Motion& motion, double t) const {
    const RigidState tank = motion.state(t);
    Vec<3> lab = -0.5 * gravity * t * t * Vec<3>::Unit(1);
    lab.head<D>() += at + t * velocity;
    return (tank.pivot + tank.orientation.conjugate() * (lab - tank.pivot - tank.displacement)).template head<D>();
  }
  Vec<D> speed(const Motion& motion, double t) const {
    constexpr double h = 1e-5;
    return (position(motion, t + h) - position(motion, t - h)) / (2 * h);
  }
};

const Thrown<2> thrown_2d{{0.1, 0.2}, {0.4, 1.5}};

/// Distance, after 0.5 s in so many steps, from where it is by the body force to where it is.
template <int D>
double error_of_flight(const Motion& motion, const Thrown<D>& thrown, int steps) {
  const double dt = 0.5 / steps;
  Vec<D> r = thrown.position(motion, 0), u = thrown.speed(motion, 0);
  for (int k = 0; k < steps; ++k) {
    const Vec<D> old = u;
    u += dt * body_force<D>(motion, g, k * dt, dt)(r, u);
    r += 0.5 * dt * (old + u);
  }
  return (r - thrown.position(motion, 0.5)).norm();
}

template <int D>
void expect_first_order(const Motion& motion, const Thrown<D>& thrown) {
  const auto error = [&](int steps) { return error_of_flight(motion, thrown, steps); };
  EXPECT_LT(error(200), 0.01);
  EXPECT_NEAR(std::log2(error(100) / error(200)), 1, 0.15);
  EXPECT_LT(error(20000), 1e-4) << "to where the body is, and nowhere else";
}

TEST(BodyForce, CarriesAFreeBodyAlongItsParabolaToFirstOrderInARollingTank) {
  expect_first_order(moving(true), thrown_2d);
}

TEST(BodyForce, CarriesAFreeBodyAlongItsParabolaInAllSixDegreesOfFreedom) {
  Parameters::Motion m{.type = MotionType::harmonics};
  m.harmonics = {{DegreeOfFreedom::surge, 0.05, 1.1, 20}, {DegreeOfFreedom::heave, 0.03, 0.6, 0},
                 {DegreeOfFreedom::sway, 0.04, 0.9, 70},  {DegreeOfFreedom::roll, 15, 0.8, 40},
                 {DegreeOfFreedom::pitch, 10, 0.7, 10},   {DegreeOfFreedom::yaw, 20, 0.5, -30}};
  m.pivot_x = 0.3;
  m.pivot_y = -0.1;
  expect_first_order(Motion(m), Thrown<3>{{0.1, 0.2, 0.3}, {0.4, 1.5, -0.3}});
}

// As the stabilised order steps: a velocity belongs to the middle between two positions.
TEST(BodyForce, CarriesAFreeBodyAlongItsLineToSecondOrderInATankThatSpins) {
  Parameters::Motion m{.type = MotionType::file, .pivot_x = 0.3, .pivot_y = -0.1};
  m.series.time = {0, 0.4, 0.8, 1.2};
  m.series[DegreeOfFreedom::roll] = {0, 80, 160, 240};
  const Motion motion(m);
  const Thrown<2> thrown{{0.1, 0.2}, {0.4, 0.5}, 0};
  const auto error = [&](int steps) {
    const double dt = 0.5 / steps;
    Vec<2> r = thrown.position(motion, 0.1), u = thrown.speed(motion, 0.1 - 0.5 * dt);
    for (int k = 0; k < steps; ++k) {
      const auto force = body_force<2>(motion, 0, 0.1 + k * dt, dt);
      const Vec<2> turned = u + dt * (force.of_velocity * u);
      u += dt * force(r, u);
      r += dt * u;
      u += force.of_gain * (u - turned);
    }
    return (r - thrown.position(motion, 0.6)).norm();
  };
  EXPECT_LT(error(100), 1e-3);
  EXPECT_NEAR(std::log2(error(100) / error(200)), 2, 0.1);
}

TEST(BodyForce, GivesAFreeBodyItsExactVelocityInATankThatOnlyTranslates) {
  const Motion motion = moving(false);
  const Thrown<2>& thrown = thrown_2d;
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
  Parameters::Motion m{.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 90, 1}};
  const auto force = body_force<2>(Motion(m), 0, 0, 0.01);
  const Vec<2> pivot = Vec<2>::Zero(), u(0.3, -1.2);
  EXPECT_NEAR((u + 0.01 * (force(pivot, u) - force(pivot, Vec<2>::Zero()))).norm(), u.norm(), 1e-14);
}

TEST(BodyForce, ActsInThePlaneOfTheRoll) {
  const Motion motion = moving(true);
  const Vec<3> r(0.5, 0.2, 0.7), u(1, 2, 3);
  const auto flat = body_force<2>(motion, g, 0.1, 1e-3)(r.head<2>(), u.head<2>());
  const auto force = body_force<3>(motion, g, 0.1, 1e-3)(r, u);
  EXPECT_LT((force.head<2>() - flat).norm(), 1e-14 * flat.norm());
  EXPECT_EQ(force[2], 0);
}

TEST(BodyForce, KnowsItsDivergenceOverLiquidAtRestInTheLab) {
  Parameters::Motion m{.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 30, 1, 20}};
  const Motion motion(m);
  constexpr double t = 0.1, dt = 1e-6, h = 1e-3;
  const auto force = body_force<2>(motion, g, t, dt);
  const double rate = motion.at(DegreeOfFreedom::roll, t).rate;
  const auto at = [&](double x, double y) { return force({x, y}, {rate * y, -rate * x}); };
  const double divergence = (at(h, 0)[0] - at(-h, 0)[0] + at(0, h)[1] - at(0, -h)[1]) / (2 * h);
  EXPECT_NEAR(force.divergence, divergence, 1e-4 * rate * rate);
  EXPECT_NEAR(force.divergence, -2 * rate * rate, 1e-4 * rate * rate);
}

// Of liquid at rest in the lab, u = -w x d: its divergence is the trace of what the force is linear in r by.
TEST(BodyForce, KnowsItsDivergenceInThreeDimensions) {
  Parameters::Motion m{.type = MotionType::harmonics};
  m.harmonics = {
      {DegreeOfFreedom::roll, 30, 1, 20}, {DegreeOfFreedom::pitch, 20, 0.7, 0}, {DegreeOfFreedom::yaw, 25, 0.4, 60}};
  const Motion motion(m);
  constexpr double t = 0.1, dt = 1e-6;
  const auto force = body_force<3>(motion, g, t, dt);
  const Vec<3> w = motion.state(t).omega;
  double divergence = 0;
  for (int a = 0; a < 3; ++a) {
    const Vec<3> r = Vec<3>::Unit(a);
    divergence += (force(r, -w.cross(r)) - force(Vec<3>::Zero(), Vec<3>::Zero()))[a];
  }
  EXPECT_NEAR(force.divergence, divergence, 1e-4 * w.squaredNorm());
}

TEST(StartForce, GivesLiquidAtRestInTheLabItsVelocityInTheTank) {
  const Motion motion = moving(true);
  const Thrown<2> rest{{0.2, 0.15}, {0, 0}};
  const Vec<2> r = rest.position(motion, 0);
  EXPECT_LT((0.01 * start_force<2>(motion, 0.01)(r, Vec<2>::Zero()) - rest.speed(motion, 0)).norm(), 1e-8);
}

}  // namespace
}  // namespace seiche::solver
