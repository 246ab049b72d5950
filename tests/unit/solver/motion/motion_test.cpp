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

/// Expects the tank to be turned by that product of rotations about directions of the tank.
void expect_turned(const Parameters::Motion& p,
                   const std::vector<std::pair<DegreeOfFreedom, Eigen::Vector3d>>& factors) {
  const Motion m(p);
  const double t = 0.7;
  Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
  for (const auto& [f, axis] : factors) expected *= Eigen::AngleAxisd(m.at(f, t).value, axis).toRotationMatrix();
  EXPECT_LT((m.state(t).orientation.toRotationMatrix() - expected).norm(), 1e-14);
}

TEST(State, IsTurnedInTheOrderThatIsAskedFor) {
  using enum DegreeOfFreedom;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  Parameters::Motion m = tumbling();
  expect_turned(m, {{roll, z}, {yaw, y}, {pitch, x}});
  m.rotation_order = RotationOrder::xyz;
  expect_turned(m, {{pitch, x}, {yaw, y}, {roll, z}});
  m.axes = MotionAxes::ship;
  m.tank_x = TankX::forward;
  expect_turned(m, {{roll, x}, {pitch, -z}, {yaw, y}});
  m.rotation_order = RotationOrder::zyx;
  expect_turned(m, {{yaw, y}, {pitch, -z}, {roll, x}});
  m.tank_x = TankX::port;
  expect_turned(m, {{yaw, y}, {pitch, x}, {roll, z}});
}

TEST(State, OfAShipIsDisplacedAlongItsAxes) {
  Parameters::Motion m = tumbling();
  m.axes = MotionAxes::ship;
  m.tank_x = TankX::forward;
  const Motion ship(m);
  const RigidState state = ship.state(0.3);
  EXPECT_EQ(state.displacement[0], ship.at(DegreeOfFreedom::surge, 0.3).value);
  EXPECT_EQ(state.displacement[1], ship.at(DegreeOfFreedom::heave, 0.3).value);
  EXPECT_EQ(state.displacement[2], -ship.at(DegreeOfFreedom::sway, 0.3).value);
}

TEST(State, OfARollIsTheSameThroughTheTanksAxesAndThroughAShips) {
  Parameters::Motion tank{.type = MotionType::harmonics};
  tank.harmonics = {{DegreeOfFreedom::roll, 12, 0.7, 30}, {DegreeOfFreedom::surge, 0.02, 0.9, 0}};
  Parameters::Motion ship = tank;
  ship.harmonics[1].of = DegreeOfFreedom::sway;
  ship.axes = MotionAxes::ship;
  ship.tank_x = TankX::port;
  for (const double t : {0.0, 0.4, 1.3}) {
    const RigidState a = Motion(tank).state(t), b = Motion(ship).state(t);
    EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
    EXPECT_EQ(a.omega, b.omega);
    EXPECT_EQ(a.alpha, b.alpha);
    EXPECT_EQ(a.displacement, b.displacement);
    EXPECT_EQ(a.acceleration, b.acceleration);
  }
}

TEST(State, OfATumblingShipHasTheRatesOfItsOrientation) {
  Parameters::Motion p = tumbling();
  p.axes = MotionAxes::ship;
  p.tank_x = TankX::forward;
  p.rotation_order = RotationOrder::xyz;
  p.pivot_z = -2;
  const Motion m(p);
  const double t = 0.7, h = 3e-6;
  const RigidState before = m.state(t - h), after = m.state(t + h), now = m.state(t);
  const Eigen::AngleAxisd turn(before.orientation.conjugate() * after.orientation);
  EXPECT_LT((turn.angle() / (2 * h) * turn.axis() - now.omega).norm(), 1e-8);
  EXPECT_LT(((after.omega - before.omega) / (2 * h) - now.alpha).norm(), 1e-8);
  EXPECT_EQ(now.pivot, Eigen::Vector3d(0.3, 0.1, -2));
  EXPECT_LT((now.in_lab(now.pivot) - now.pivot - now.displacement).norm(), 1e-15);
}

struct Tumbling : ::testing::TestWithParam<RotationOrder> {};
INSTANTIATE_TEST_SUITE_P(Orders, Tumbling, ::testing::Values(RotationOrder::zyx, RotationOrder::xyz));

TEST_P(Tumbling, BoxIsWithinItsExtentAndFastest) {
  Parameters::Motion p = tumbling();
  p.rotation_order = GetParam();
  const Motion m(p);
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

/// A record of surge from 0.1 to 0.6 s.
Parameters::Motion late() {
  Parameters::Motion m{.type = MotionType::file};
  for (int k = 1; k <= 6; ++k) {
    m.series.time.push_back(0.1 * k);
    m.series[DegreeOfFreedom::surge].push_back(0.01 * k * k);
    m.series[DegreeOfFreedom::yaw].push_back(0);
  }
  return m;
}

TEST(MotionFile, MovesNothingByAColumnThatIsZeroThroughout) {
  EXPECT_FALSE(Motion(late()).moves(DegreeOfFreedom::yaw));
  EXPECT_FALSE(Motion(late()).rotates());
}

TEST(MotionFile, BeginsWhereTheSceneSays) {
  Parameters::Motion m = late();
  m.from = 0.1;
  EXPECT_NEAR(Motion(m).at(DegreeOfFreedom::surge, 0).value, 0.01, 1e-15);
  EXPECT_NEAR(Motion(m).at(DegreeOfFreedom::surge, 0.25).value, 0.01 * 3.5 * 3.5, 1e-14);
}

TEST(MotionFile, StandsStillBeforeItsFirstSampleAndAfterItsLastWhereItIsHeld) {
  Parameters::Motion m = late();
  m.hold = true;
  const Motion held(m);
  const auto expect_still = [&](double t, double value) {
    const Jet jet = held.at(DegreeOfFreedom::surge, t);
    EXPECT_NEAR(jet.value, value, 1e-15);
    EXPECT_EQ(jet.rate, 0);
    EXPECT_EQ(jet.acceleration, 0);
  };
  expect_still(0.05, 0.01);
  expect_still(0.7, 0.36);
  EXPECT_NEAR(held.at(DegreeOfFreedom::surge, 0.2).rate, 0.4, 1e-12);
}

TEST(MotionFile, IsSmoothedAboveItsCutoff) {
  Parameters::Motion m{.type = MotionType::file};
  for (int k = 0; k <= 400; ++k) {
    m.series.time.push_back(0.01 * k);
    m.series[DegreeOfFreedom::heave].push_back(std::sin(2 * std::numbers::pi * 0.01 * k));
  }
  m.cutoff = 2;
  EXPECT_NEAR(Motion(m).at(DegreeOfFreedom::heave, 2.25).value, 1 / (1 + std::pow(0.5, 4)), 2e-3);
}

}  // namespace
}  // namespace seiche::solver
