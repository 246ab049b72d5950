#include "solver/motion/motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/unit/headers.hpp"

namespace seiche::solver {
namespace {

std::vector<std::string> headers_of(const Parameters::Motion& m) {
  return seiche::test::headers(motion_columns(m, {1, 1, 1}));
}

constexpr double amplitude = 0.005, frequency = 1.25, omega = 2 * std::numbers::pi * frequency;
constexpr double degree = std::numbers::pi / 180;
const Motion surge({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, amplitude, frequency}});

/// All three at once, each with another frequency.
Parameters::Motion everything() {
  Parameters::Motion m{.type = MotionType::harmonics};
  m.harmonics = {{DegreeOfFreedom::surge, 0.01, 1, 0},
                 {DegreeOfFreedom::heave, 0.02, 0.5, 90},
                 {DegreeOfFreedom::roll, 2, 0.7, 30},
                 {DegreeOfFreedom::roll, 0.5, 2.1, 0},
                 {DegreeOfFreedom::surge, 0.003, 3, 0}};
  m.pivot_x = 0.3;
  m.pivot_y = 0.1;
  return m;
}

TEST(Surge, StartsFromTheMiddleAtFullSpeed) {
  EXPECT_EQ(surge.at(DegreeOfFreedom::surge, 0).value, 0);
  EXPECT_DOUBLE_EQ(surge.at(DegreeOfFreedom::surge, 0).rate, amplitude * omega);
  EXPECT_DOUBLE_EQ(surge.fastest(), amplitude * omega);
  EXPECT_DOUBLE_EQ(surge.greatest_acceleration(), amplitude * omega * omega);
  EXPECT_NEAR(surge.at(DegreeOfFreedom::surge, 0.25 / frequency).value, amplitude, 1e-17);
  EXPECT_NEAR(surge.at(DegreeOfFreedom::surge, 0.25 / frequency).rate, 0, 1e-16);
  EXPECT_NEAR(surge.at(DegreeOfFreedom::surge, 0.25 / frequency).acceleration, -omega * omega * amplitude, 1e-12);
  EXPECT_EQ(surge.at(DegreeOfFreedom::heave, 0.1).value, 0);
  EXPECT_FALSE(surge.rotates());
}

TEST(Surge, JumpsUnlessItStartsSmoothlyOrFromItsTurningPoint) {
  EXPECT_TRUE(surge.jumps());
  EXPECT_FALSE(
      Motion({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 1, 1}, .start = Start::smooth})
          .jumps());
  EXPECT_FALSE(Motion({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 1, 1}, .ramp = 1}).jumps());
  EXPECT_FALSE(Motion({.type = MotionType::none, .harmonic = {DegreeOfFreedom::surge, 1, 1}}).jumps());
}

TEST(Surge, FastestIsNeverNegative) {
  EXPECT_GT(Motion({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, -0.1, 1}}).fastest(), 0);
}

TEST(Harmonics, AddUpByWhatTheyMove) {
  const Motion m(everything());
  const double t = 0.37, turn = 2 * std::numbers::pi * t;
  EXPECT_NEAR(m.at(DegreeOfFreedom::surge, t).value, 0.01 * std::sin(turn) + 0.003 * std::sin(3 * turn), 1e-16);
  EXPECT_NEAR(m.at(DegreeOfFreedom::heave, t).value, 0.02 * std::cos(0.5 * turn), 1e-16);
  EXPECT_NEAR(m.at(DegreeOfFreedom::roll, t).value,
              degree * (2 * std::sin(0.7 * turn + 30 * degree) + 0.5 * std::sin(2.1 * turn)), 1e-16);
  EXPECT_TRUE(m.rotates());
}

TEST(Rest, IsWhateverElseIsGiven) {
  Parameters::Motion m = everything();
  m.type = MotionType::none;
  const Motion rest(m);
  EXPECT_EQ(rest.at(DegreeOfFreedom::surge, 0.1).value, 0);
  EXPECT_EQ(rest.at(DegreeOfFreedom::roll, 0.1).rate, 0);
  EXPECT_EQ(rest.fastest(1), 0);
  EXPECT_TRUE(headers_of(m).empty());
}

TEST(Pose, CarriesPointsToWhereTheyAreAndFastestAndExtentBoundThem) {
  const Motion m(everything());
  const Double3 low{0, 0, 0}, high{0.6, 0.4, 0}, extent = m.extent(low, high);
  const double reach = std::hypot(0.3, 0.3), h = 1e-6;
  const auto corner = [&](double t, double x, double y) { return m.state(t).in_lab({x, y, 0}); };
  double farthest[] = {0, 0}, fastest = 0;
  for (double t = 0; t < 20; t += 0.013)
    for (double x : {0., 0.6})
      for (double y : {0., 0.4}) {
        const auto before = corner(t - h, x, y), after = corner(t + h, x, y), now = corner(t, x, y);
        fastest = std::max(fastest, std::hypot(after[0] - before[0], after[1] - before[1]) / (2 * h));
        farthest[0] = std::max(farthest[0], std::abs(now[0] - x));
        farthest[1] = std::max(farthest[1], std::abs(now[1] - y));
      }
  EXPECT_LE(fastest, m.fastest(reach));
  EXPECT_GT(fastest, 0.6 * m.fastest(reach)) << "a bound worth having";
  for (int axis : {0, 1}) {
    EXPECT_LE(farthest[axis], extent[axis]);
    EXPECT_GT(farthest[axis], 0.8 * extent[axis]) << "a margin worth having";
  }
}

/// All six at once, the rotations large.
Parameters::Motion tumbling() {
  Parameters::Motion m{.type = MotionType::harmonics};
  m.harmonics = {{DegreeOfFreedom::surge, 0.01, 1, 0},   {DegreeOfFreedom::heave, 0.02, 0.5, 90},
                 {DegreeOfFreedom::sway, 0.03, 0.8, 45}, {DegreeOfFreedom::roll, 50, 0.7, 30},
                 {DegreeOfFreedom::pitch, 40, 0.4, 80},  {DegreeOfFreedom::yaw, 70, 0.3, -20}};
  m.pivot_x = 0.3;
  m.pivot_y = 0.1;
  return m;
}

TEST(State, HasTheRatesOfItsPositionAndOrientation) {
  const Motion m(tumbling());
  const double t = 0.7, h = 3e-6;
  const RigidState before = m.state(t - h), after = m.state(t + h), now = m.state(t);
  EXPECT_LT(((after.displacement - before.displacement) / (2 * h) - now.velocity).norm(), 1e-9);
  EXPECT_LT(((after.velocity - before.velocity) / (2 * h) - now.acceleration).norm(), 1e-8);
  const Eigen::AngleAxisd turn(before.orientation.conjugate() * after.orientation);
  EXPECT_LT((turn.angle() / (2 * h) * turn.axis() - now.omega).norm(), 1e-8);
  EXPECT_LT(((after.omega - before.omega) / (2 * h) - now.alpha).norm(), 1e-8);
  EXPECT_EQ(now.pivot, Eigen::Vector3d(0.3, 0.1, 0));
}

TEST(State, IsTurnedByRollThenPitchThenYaw) {
  const Motion m(tumbling());
  const double t = 0.7;
  const auto turn = [&](DegreeOfFreedom f, int axis) {
    return Eigen::AngleAxisd(m.at(f, t).value, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
  };
  const Eigen::Matrix3d expected =
      turn(DegreeOfFreedom::yaw, 1) * turn(DegreeOfFreedom::pitch, 0) * turn(DegreeOfFreedom::roll, 2);
  EXPECT_LT((m.state(t).orientation.toRotationMatrix() - expected).norm(), 1e-14);
}

TEST(State, OfATumblingBoxIsWithinItsExtentAndFastest) {
  const Motion m(tumbling());
  const Double3 extent = m.extent({0, 0, 0}, {0.6, 0.4, 0.2});
  const double reach = Eigen::Vector3d(0.3, 0.3, 0.2).norm();
  for (double t = 0; t < 20; t += 0.013) {
    const RigidState tank = m.state(t);
    EXPECT_LE(tank.velocity.norm() + tank.omega.norm() * reach, m.fastest(reach));
    EXPECT_LE(tank.acceleration.norm() + (tank.alpha.norm() + tank.omega.squaredNorm()) * reach,
              m.greatest_acceleration(reach));
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d r(corner & 1 ? 0.6 : 0, corner & 2 ? 0.4 : 0, corner & 4 ? 0.2 : 0);
      const Eigen::Vector3d moved = tank.in_lab(r) - r;
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(moved[axis]), extent[axis]);
    }
  }
}

TEST(MotionColumns, AreOfWhatMovesAndHaveTheirValues) {
  EXPECT_EQ(headers_of({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge}}),
            std::vector<std::string>{"surge [m]"});
  EXPECT_EQ(headers_of({.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll}}),
            std::vector<std::string>{"roll [deg]"});
  EXPECT_EQ(headers_of(everything()), (std::vector<std::string>{"surge [m]", "heave [m]", "roll [deg]"}));
  std::vector<double> values{7};
  const Motion m(everything());
  m.append(0.2, values);
  ASSERT_EQ(values.size(), 4u);
  EXPECT_EQ(values[1], m.at(DegreeOfFreedom::surge, 0.2).value);
  EXPECT_EQ(values[2], m.at(DegreeOfFreedom::heave, 0.2).value);
  EXPECT_NEAR(values[3], m.at(DegreeOfFreedom::roll, 0.2).value / degree, 1e-15);
}

TEST(MotionFile, IsFollowedAndMovesOnlyItsColumns) {
  Parameters::Motion m{.type = MotionType::file};
  for (int k = 0; k <= 10; ++k) {
    m.series.time.push_back(0.1 * k);
    m.series[DegreeOfFreedom::heave].push_back(0.01 * k * k);
    m.series[DegreeOfFreedom::roll].push_back(3.0 * k);
  }
  const Motion motion(m);
  EXPECT_NEAR(motion.at(DegreeOfFreedom::heave, 0.55).value, 0.01 * 5.5 * 5.5, 1e-14);
  EXPECT_NEAR(motion.at(DegreeOfFreedom::roll, 0.55).rate, 30 * degree, 1e-13);
  EXPECT_EQ(motion.at(DegreeOfFreedom::surge, 0.55).value, 0);
  EXPECT_EQ(headers_of(m), (std::vector<std::string>{"heave [m]", "roll [deg]"}));
  EXPECT_NEAR(motion.extent({}, {1, 0, 0})[1], 1 + std::sin(30 * degree), 1e-12) << "heave, and the far end's rise";
}

}  // namespace
}  // namespace seiche::solver
