#include "solver/sensors/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "solver/make_simulation.hpp"
#include "tests/unit/headers.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

/// A still tank whose corner pressure is `pressure` at a time.
struct SampledTank : ::testing::Test {
  Parameters p = test::small_tank<2>();
  State<2> s = fill_tank<2>(p);
  std::size_t columns = sensor_columns(p).size();

  static double ramp(double t) { return 100 + 5000 * t; }

  void start(Sensors<2>& sensors, SensorMemory& memory, double pressure) {
    set(0, pressure);
    sensors.read(s, memory);
  }
  /// A step that ends at a time with a pressure.
  void step(Sensors<2>& sensors, SensorMemory& memory, double end, double pressure) {
    sensors.before_step(s, end, memory);
    set(end, pressure);
    sensors.read(s, memory);
  }
  void set(double time, double pressure) {
    s.time = time;
    std::fill(s.pressure.begin(), s.pressure.end(), pressure);
  }
  double pressure(const Readings& readings, std::size_t row) const { return readings.values[columns * row]; }
};

TEST_F(SampledTank, InterpolatesToExactSampleTimes) {
  Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.01);
  SensorMemory memory;
  start(sensors, memory, ramp(0));
  for (double t : {0.004, 0.011, 0.0195, 0.0445, 0.05}) step(sensors, memory, t, ramp(t));
  const Readings readings = std::exchange(memory.readings, {});
  ASSERT_EQ(readings.time.size(), 6u);
  ASSERT_EQ(readings.values.size(), 6 * columns);
  for (int k = 0; k < 6; ++k) {
    EXPECT_DOUBLE_EQ(readings.time[k], 0.01 * k);
    EXPECT_NEAR(pressure(readings, k), ramp(0.01 * k), 1e-9);
  }
}

// A thousand samples a second from steps that are much shorter, a little shorter and longer than a sample.
TEST_F(SampledTank, SamplesAtOneKilohertzWhateverTheStep) {
  for (double dt : {0.00013, 0.00071, 0.001, 0.0013, 0.0047}) {
    Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.001);
    SensorMemory memory;
    start(sensors, memory, ramp(0));
    for (int k = 1; k * dt <= 0.0501; ++k) step(sensors, memory, k * dt, ramp(k * dt));
    const Readings readings = std::exchange(memory.readings, {});
    ASSERT_GE(readings.time.size(), 46u) << dt;
    for (std::size_t k = 0; k < readings.time.size(); ++k) {
      EXPECT_DOUBLE_EQ(readings.time[k], 0.001 * static_cast<double>(k)) << dt;
      EXPECT_NEAR(pressure(readings, k), ramp(0.001 * static_cast<double>(k)), 1e-9) << dt;
    }
  }
}

// Only the step around a sample matters: the pressures between are nonsense, and aren't seen.
TEST_F(SampledTank, InterpolatesOverTheStepAroundTheSampleAlone) {
  Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.01);
  SensorMemory memory;
  start(sensors, memory, 1);
  for (double t : {0.002, 0.004, 0.006}) step(sensors, memory, t, 1e6);
  step(sensors, memory, 0.008, 10);
  step(sensors, memory, 0.012, 20);
  const Readings readings = std::exchange(memory.readings, {});
  ASSERT_EQ(readings.time.size(), 2u);
  EXPECT_NEAR(pressure(readings, 1), 15, 1e-9);
}

TEST_F(SampledTank, TakesEachReadingOnce) {
  Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.01);
  SensorMemory memory;
  start(sensors, memory, 1);
  step(sensors, memory, 0.015, 2);
  EXPECT_EQ(std::exchange(memory.readings, {}).time, (std::vector<double>{0, 0.01}));
  EXPECT_TRUE(std::exchange(memory.readings, {}).time.empty());
  step(sensors, memory, 0.025, 3);
  const Readings readings = std::exchange(memory.readings, {});
  EXPECT_EQ(readings.time, std::vector<double>{0.02});
  EXPECT_NEAR(pressure(readings, 0), 2.5, 1e-9) << "halfway from the reading before the last call";
}

TEST_F(SampledTank, ASampleAtTheVeryEndOfAStepIsTaken) {
  Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.1);
  SensorMemory memory;
  double time = 0;
  start(sensors, memory, 0);
  for (int k = 0; k < 3; ++k) step(sensors, memory, time += 0.1, k);  // 0.1 + 0.1 + 0.1 isn't 3 * 0.1
  EXPECT_EQ(std::exchange(memory.readings, {}).time.size(), 4u);
}

TEST_F(SampledTank, HasNoReadingsWithoutAnInterval) {
  Sensors<2> sensors({p, *make_shape<2>(p), s}, 0);
  SensorMemory memory;
  start(sensors, memory, 1);
  step(sensors, memory, 1, 1);
  EXPECT_TRUE(std::exchange(memory.readings, {}).time.empty());
}

TEST_F(SampledTank, HasAValueForEveryColumnAndNoOther) {
  p.sensors.pressure = {{"a", 0, 0.02, 0, 0.01}, {"b", 0.1, 0, 0, 0}};
  p.sensors.gauge = {{"a", 0.04, 0}};
  const std::map<std::string, double> still{{"p_a [Pa]", 9810 * 0.08}, {"p_b [Pa]", 981},   {"force_y [N/m]", -196.2},
                                            {"volume [m^2]", 0.02},    {"x_mass [m]", 0.1}, {"y_mass [m]", 0.05}};
  for (int off = 0; off < 8; ++off) {
    p.sensors.force = off & 1;
    p.sensors.energy = off & 2;
    p.sensors.volume = off & 4;
    Sensors<2> sensors({p, *make_shape<2>(p), s}, 0.1);
    SensorMemory memory;
    sensors.read(s, memory);
    const Readings readings = std::exchange(memory.readings, {});
    const auto names = seiche::test::headers(sensor_columns(p));
    ASSERT_EQ(readings.values.size(), names.size()) << off;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto expected = still.find(names[k]);
      if (expected != still.end()) {
        EXPECT_NEAR(readings.values[k], expected->second, 1e-8) << names[k];
      }
    }
  }
}

template <class T>
struct SensorsOf : ::testing::Test {};
TYPED_TEST_SUITE(SensorsOf, test::Dimensions);

TYPED_TEST(SensorsOf, ReadStillWaterInTheCornerAndAtBothEnds) {
  constexpr int D = TypeParam::D;
  const Parameters p = test::small_tank<D>();
  const State<D> s = fill_tank<D>(p);
  Sensors<D> sensors({p, *make_shape<D>(p), s}, 0.01);
  SensorMemory memory;
  sensors.read(s, memory);
  const Readings readings = std::exchange(memory.readings, {});
  ASSERT_EQ(readings.time, std::vector<double>{0});
  ASSERT_EQ(readings.values.size(), sensor_columns(p).size());
  EXPECT_NEAR(readings.values[0], 981, 1e-8);
  EXPECT_EQ(readings.values[1], 0) << "round-off is no wave";
  EXPECT_EQ(readings.values[2], 0);
  EXPECT_FALSE(std::signbit(readings.values[1]) || std::signbit(readings.values[2]));
}

TYPED_TEST(SensorsOf, TellLeftFromRight) {
  constexpr int D = TypeParam::D;
  const Parameters p = test::small_tank<D>();
  State<D> s = fill_tank<D>(p);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.position[i][1] += s.position[i][0] < 0.1 ? 0.02 : 0.01;
  Sensors<D> sensors({p, *make_shape<D>(p), s}, 0.01);
  SensorMemory memory;
  sensors.read(s, memory);
  const Readings readings = std::exchange(memory.readings, {});
  EXPECT_NEAR(readings.values[1], 0.02, 0.05 * test::l0);
  EXPECT_NEAR(readings.values[2], 0.01, 0.05 * test::l0);
}

}  // namespace
}  // namespace seiche::solver
