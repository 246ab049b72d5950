#include "solver/sensors/gauge_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

/// 0.2 m x 0.15 m, in 3-D 0.12 m wide, filled to 0.1 m.
template <class T, int D = T::D>
struct GaugeLineOf : ::testing::Test {
  SensedTank<D> tank;

  GaugeLine<D> line(const Parameters::WaveGauge& gauge) const {
    return line_of(gauge, *tank.shape, levels_of(tank.p, *tank.shape));
  }
  double reading(const Parameters::WaveGauge& gauge) const {
    SurfaceProfile<D> surface = tank.profile();
    surface.find(tank.s, tank.cells());
    return crossing_of(line(gauge), surface);
  }
};
TYPED_TEST_SUITE(GaugeLineOf, test::Dimensions);

TYPED_TEST(GaugeLineOf, GoesUpAsFarAsTheTankDoes) {
  const auto line = this->line({.name = "a", .x = 0.05, .z = 0.06});
  EXPECT_NEAR(line.point[1], 0.1, 1e-12);
  EXPECT_NEAR(line.low, -0.1, 1e-6 * l0);
  EXPECT_NEAR(line.high, 0.05, 1e-6 * l0);
  EXPECT_EQ(line.still, 0);
}

TYPED_TEST(GaugeLineOf, AtAnAngleCrossesStillLevelWhereItShould) {
  const double angle = std::numbers::pi / 3;
  const Parameters::WaveGauge gauge{
      .name = "a", .x = 0.1, .z = 0.06, .y = 0.05, .direction = {std::cos(angle), std::sin(angle), 0}};
  const auto line = this->line(gauge);
  EXPECT_NEAR(*line.still, 0.05 / std::sin(angle), 1e-12);
  EXPECT_NEAR(line.low, -0.05 / std::sin(angle), 1e-6 * l0);
  // Half of the fluid fraction lies on a flat surface, whatever way a line comes.
  EXPECT_NEAR(this->reading(gauge), *line.still, 0.02 * l0);
}

// A column of water, 0.1 m long: a level line meets its side.
TYPED_TEST(GaugeLineOf, ThatIsLevelReadsTheWayFromItsPoint) {
  constexpr int D = TypeParam::D;
  Parameters p = test::small_tank<D>();
  p.fluid.column = 0.1;
  this->tank = SensedTank<D>(p);
  const Parameters::WaveGauge gauge{.name = "a", .x = 0.02, .z = 0.06, .y = 0.05, .direction = {1, 0, 0}};
  EXPECT_FALSE(this->line(gauge).still);
  EXPECT_NEAR(this->reading(gauge), 0.1 - 0.02, 0.02 * l0);
}

// The upper half of the water goes up by 4 l0: both ends of liquid on an upright line.
TYPED_TEST(GaugeLineOf, ReadsTheHighestAndTheLowestCrossing) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) {
    if (r[1] > 0.05) r[1] += 4 * l0;
  });
  Parameters::WaveGauge gauge{.name = "a", .x = 0.1, .z = 0.06};
  EXPECT_NEAR(this->reading(gauge), 4 * l0, 0.02 * l0);
  gauge.crossing = Crossing::lowest;
  EXPECT_NEAR(this->reading(gauge), -0.05, 0.02 * l0);
}

TYPED_TEST(GaugeLineOf, ThatIsDryReadsItsLowerEnd) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) { r[0] = 0.25 * r[0] + 0.00375; });
  const Parameters::WaveGauge gauge{.name = "a", .x = 0.15, .z = 0.06};
  EXPECT_NEAR(this->reading(gauge), -0.1, 1e-6 * l0);
}

}  // namespace
}  // namespace seiche::solver
