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
const Motion surge({.type = "surge", .amplitude = amplitude, .frequency = frequency});

/// All three at once, each with another frequency.
Parameters::Motion everything() {
  Parameters::Motion m{.type = "harmonics"};
  m.harmonics = {{"surge", 0.01, 1, 0},
                 {"heave", 0.02, 0.5, 90},
                 {"roll", 2, 0.7, 30},
                 {"roll", 0.5, 2.1, 0},
                 {"surge", 0.003, 3, 0}};
  m.pivot_x = 0.3;
  m.pivot_y = 0.1;
  return m;
}

TEST(Surge, StartsFromTheMiddleAtFullSpeed) {
  EXPECT_EQ(surge.surge(0).value, 0);
  EXPECT_DOUBLE_EQ(surge.surge(0).rate, amplitude * omega);
  EXPECT_DOUBLE_EQ(surge.fastest(), amplitude * omega);
  EXPECT_NEAR(surge.surge(0.25 / frequency).value, amplitude, 1e-17);
  EXPECT_NEAR(surge.surge(0.25 / frequency).rate, 0, 1e-16);
  EXPECT_NEAR(surge.surge(0.25 / frequency).acceleration, -omega * omega * amplitude, 1e-12);
  EXPECT_EQ(surge.heave(0.1).value, 0);
  EXPECT_FALSE(surge.rolls());
}

TEST(Surge, JumpsUnlessItStartsSmoothlyOrFromItsTurningPoint) {
  EXPECT_TRUE(surge.jumps());
  EXPECT_FALSE(Motion({.type = "surge", .amplitude = 1, .frequency = 1, .start = Start::smooth}).jumps());
  EXPECT_FALSE(Motion({.type = "surge", .amplitude = 1, .frequency = 1, .ramp = 1}).jumps());
  EXPECT_FALSE(Motion({.type = "none", .amplitude = 1, .frequency = 1}).jumps());
}

TEST(Surge, FastestIsNeverNegative) {
  EXPECT_GT(Motion({.type = "surge", .amplitude = -0.1, .frequency = 1}).fastest(), 0);
}

TEST(Harmonics, AddUpByWhatTheyMove) {
  const Motion m(everything());
  const double t = 0.37, turn = 2 * std::numbers::pi * t;
  EXPECT_NEAR(m.surge(t).value, 0.01 * std::sin(turn) + 0.003 * std::sin(3 * turn), 1e-16);
  EXPECT_NEAR(m.heave(t).value, 0.02 * std::cos(0.5 * turn), 1e-16);
  EXPECT_NEAR(m.roll(t).value, degree * (2 * std::sin(0.7 * turn + 30 * degree) + 0.5 * std::sin(2.1 * turn)), 1e-16);
  EXPECT_TRUE(m.rolls());
}

TEST(Rest, IsWhateverElseIsGiven) {
  Parameters::Motion m = everything();
  m.type = "none";
  const Motion rest(m);
  EXPECT_EQ(rest.surge(0.1).value, 0);
  EXPECT_EQ(rest.roll(0.1).rate, 0);
  EXPECT_EQ(rest.fastest(1), 0);
  EXPECT_TRUE(headers_of(m).empty());
}

TEST(Pose, CarriesPointsToWhereTheyAreAndFastestAndExtentBoundThem) {
  const Motion m(everything());
  const Double3 low{0, 0, 0}, high{0.6, 0.4, 0}, extent = m.extent(low, high);
  const double reach = std::hypot(0.3, 0.3), h = 1e-6;
  const auto corner = [&](double t, double x, double y) {
    const TankPose pose = m.pose(t);
    const double c = std::cos(pose.roll), s = std::sin(pose.roll), dx = x - pose.pivot[0], dy = y - pose.pivot[1];
    return std::array{pose.pivot[0] + pose.displacement[0] + c * dx - s * dy,
                      pose.pivot[1] + pose.displacement[1] + s * dx + c * dy};
  };
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

TEST(Pose, HasTheRatesOfItsPositions) {
  const Motion m(everything());
  const double t = 0.7, h = 1e-5;
  const TankPose before = m.pose(t - h), after = m.pose(t + h), now = m.pose(t);
  for (int axis : {0, 1})
    EXPECT_NEAR((after.displacement[axis] - before.displacement[axis]) / (2 * h), now.velocity[axis], 1e-9);
  EXPECT_NEAR((after.roll - before.roll) / (2 * h), now.roll_rate, 1e-8);
  EXPECT_EQ(now.pivot, (Double3{0.3, 0.1, 0}));
}

TEST(MotionColumns, AreOfWhatMovesAndHaveTheirValues) {
  EXPECT_EQ(headers_of({.type = "surge"}), std::vector<std::string>{"surge [m]"});
  EXPECT_EQ(headers_of({.type = "roll"}), std::vector<std::string>{"roll [deg]"});
  EXPECT_EQ(headers_of(everything()), (std::vector<std::string>{"surge [m]", "heave [m]", "roll [deg]"}));
  std::vector<double> values{7};
  const Motion m(everything());
  m.append(0.2, values);
  ASSERT_EQ(values.size(), 4u);
  EXPECT_EQ(values[1], m.surge(0.2).value);
  EXPECT_EQ(values[2], m.heave(0.2).value);
  EXPECT_NEAR(values[3], m.roll(0.2).value / degree, 1e-15);
}

TEST(MotionFile, IsFollowedAndMovesOnlyItsColumns) {
  Parameters::Motion m{.type = "file"};
  for (int k = 0; k <= 10; ++k) {
    m.series.time.push_back(0.1 * k);
    m.series.heave.push_back(0.01 * k * k);
    m.series.roll.push_back(3.0 * k);
  }
  const Motion motion(m);
  EXPECT_NEAR(motion.heave(0.55).value, 0.01 * 5.5 * 5.5, 1e-14);
  EXPECT_NEAR(motion.roll(0.55).rate, 30 * degree, 1e-13);
  EXPECT_EQ(motion.surge(0.55).value, 0);
  EXPECT_EQ(headers_of(m), (std::vector<std::string>{"heave [m]", "roll [deg]"}));
  EXPECT_NEAR(motion.extent({}, {1, 0, 0})[1], 1 + std::sin(30 * degree), 1e-12) << "heave, and the far end's rise";
}

}  // namespace
}  // namespace seiche::solver
