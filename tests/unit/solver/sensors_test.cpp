#include "solver/sensors.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

/// A still tank whose corner pressure is `pressure` at a time.
struct SampledTank : ::testing::Test {
  Parameters p = test::small_tank<2>();
  State<2> s = fill_tank<2>(p);

  void read_at(Sensors<2>& sensors, double time, double pressure) {
    s.time = time;
    std::fill(s.pressure.begin(), s.pressure.end(), pressure);
    sensors.read(s);
  }
  static double pressure(const Readings& readings, std::size_t row) { return readings.values[3 * row]; }
};

TEST_F(SampledTank, InterpolatesToExactSampleTimes) {
  Sensors<2> sensors(p, 0.01);
  const auto ramp = [](double t) { return 100 + 5000 * t; };
  const double steps[] = {0, 0.004, 0.011, 0.0195, 0.0445, 0.05};
  for (double t : steps) read_at(sensors, t, ramp(t));
  const Readings readings = sensors.take();
  ASSERT_EQ(readings.time.size(), 6u);
  ASSERT_EQ(readings.values.size(), 18u);
  for (int k = 0; k < 6; ++k) {
    EXPECT_DOUBLE_EQ(readings.time[k], 0.01 * k);
    EXPECT_NEAR(pressure(readings, k), ramp(0.01 * k), 1e-9);
  }
}

TEST_F(SampledTank, TakesEachReadingOnce) {
  Sensors<2> sensors(p, 0.01);
  read_at(sensors, 0, 1);
  read_at(sensors, 0.015, 2);
  EXPECT_EQ(sensors.take().time, (std::vector<double>{0, 0.01}));
  EXPECT_TRUE(sensors.take().time.empty());
  read_at(sensors, 0.025, 3);
  const Readings readings = sensors.take();
  EXPECT_EQ(readings.time, std::vector<double>{0.02});
  EXPECT_NEAR(pressure(readings, 0), 2.5, 1e-9) << "halfway from the reading before the last call";
}

TEST_F(SampledTank, ASampleAtTheVeryEndOfAStepIsTaken) {
  Sensors<2> sensors(p, 0.1);
  double time = 0;
  read_at(sensors, 0, 0);
  for (int k = 0; k < 3; ++k) read_at(sensors, time += 0.1, k);  // 0.1 + 0.1 + 0.1 isn't 3 * 0.1
  EXPECT_EQ(sensors.take().time.size(), 4u);
}

TEST_F(SampledTank, HasNoReadingsWithoutAnInterval) {
  Sensors<2> sensors(p, 0);
  read_at(sensors, 0, 1);
  read_at(sensors, 1, 1);
  EXPECT_TRUE(sensors.take().time.empty());
}

template <class T>
struct SensorsOf : ::testing::Test {};
TYPED_TEST_SUITE(SensorsOf, test::Dimensions);

TYPED_TEST(SensorsOf, ReadStillWaterInTheCornerAndAtBothEnds) {
  constexpr int D = TypeParam::D;
  const Parameters p = test::small_tank<D>();
  Sensors<D> sensors(p, 0.01);
  sensors.read(fill_tank<D>(p));
  const Readings readings = sensors.take();
  ASSERT_EQ(readings.time, std::vector<double>{0});
  ASSERT_EQ(readings.values.size(), 3u);
  EXPECT_NEAR(readings.values[0], 981, 1e-8);
  EXPECT_NEAR(readings.values[1], 0, 0.05 * test::l0);
  EXPECT_NEAR(readings.values[2], 0, 0.05 * test::l0);
}

TYPED_TEST(SensorsOf, TellLeftFromRight) {
  constexpr int D = TypeParam::D;
  const Parameters p = test::small_tank<D>();
  State<D> s = fill_tank<D>(p);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.position[i][1] += s.position[i][0] < 0.1 ? 0.02 : 0.01;
  Sensors<D> sensors(p, 0.01);
  sensors.read(s);
  const Readings readings = sensors.take();
  EXPECT_NEAR(readings.values[1], 0.02, 0.05 * test::l0);
  EXPECT_NEAR(readings.values[2], 0.01, 0.05 * test::l0);
}

}  // namespace
}  // namespace seiche::solver
