#include "solver/sensors/pressure_sensor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

template <class T, int D = T::D>
struct PressureSensorOf : ::testing::Test {
  SensedTank<D> tank;

  double read(double x, double y, double side, PressureReading reading = PressureReading::mean) const {
    return PressureSensor<D>({"s", x, y, D == 3 ? 0.06 : 0, side, reading}, *tank.shape, l0).read(tank.s, tank.cells());
  }
  double highest(double x, double y, double side) const { return read(x, y, side, PressureReading::maximum); }
  /// 2000 + 10 x - 30 y (+ 20 z), lengths in l0.
  void set_linear() {
    tank.each_fluid(
        [](const Vec<D>& r, double& p) { p = 2000 + (10 * r[0] - 30 * r[1] + (D == 3 ? 20 * r[D - 1] : 0)) / l0; });
  }
  static double linear(double x, double y) { return 2000 + (10 * x - 30 * y) / l0 + (D == 3 ? 120 : 0); }
};
TYPED_TEST_SUITE(PressureSensorOf, test::Dimensions);

TYPED_TEST(PressureSensorOf, ReadsItsPoint) {
  this->set_linear();
  EXPECT_NEAR(this->read(0, 0, 0), this->linear(0, 0), 1e-8);
  EXPECT_NEAR(this->read(0, 0.043, 0), this->linear(0, 0.043), 1e-8);
  EXPECT_NEAR(this->read(0.137, 0, 0), this->linear(0.137, 0), 1e-8);
}

TYPED_TEST(PressureSensorOf, MeanOverAnAreaOfALinearFieldIsThatOfItsCentre) {
  this->set_linear();
  for (double side : {0.001, 0.013, 0.03, 0.06}) {
    EXPECT_NEAR(this->read(0.2, 0.043, side), this->linear(0.2, 0.043), 1e-8) << side;
    EXPECT_NEAR(this->read(0.1, 0, side), this->linear(0.1, 0), 1e-8) << side;
  }
}

TYPED_TEST(PressureSensorOf, AreaEndsWithTheWall) {
  this->set_linear();
  // 0.04 about y = 0.01 is cut to 0 .. 0.03; on the floor 0.04 about x = 0.19 to 0.17 .. 0.2.
  EXPECT_NEAR(this->read(0, 0.01, 0.04), this->linear(0, 0.015), 1e-8);
  EXPECT_NEAR(this->read(0.19, 0, 0.04), this->linear(0.185, 0), 1e-8);
}

TYPED_TEST(PressureSensorOf, AreaInACornerLiesInTheSideWall) {
  this->set_linear();
  EXPECT_NEAR(this->read(0, 0, 0.04), this->linear(0, 0.01), 1e-8);
}

TYPED_TEST(PressureSensorOf, MaximumOfStillWaterIsAtTheDeepestEdge) {
  const double weight = this->tank.weight;
  for (double side : {0.001, 0.013, 0.03, 0.06})
    EXPECT_NEAR(this->highest(0, 0.043, side), weight * (0.1 - 0.043 + 0.5 * side), 1e-8) << side;
  EXPECT_NEAR(this->highest(0, 0.01, 0.04), weight * 0.1, 1e-8) << "the area ends with the wall";
  EXPECT_NEAR(this->highest(0.1, 0, 0.04), weight * 0.1, 1e-8) << "the floor is level";
}

TYPED_TEST(PressureSensorOf, MaximumOfALinearFieldIsAtACornerOfTheArea) {
  constexpr int D = TypeParam::D;
  this->set_linear();
  // In 3-D the pressure grows by 20 a spacing across, too: half a side of 3 l0 to the edge.
  EXPECT_NEAR(this->highest(0.2, 0.045, 0.03), this->linear(0.2, 0.03) + (D == 3 ? 30 : 0), 1e-8);
  EXPECT_NEAR(this->highest(0.1, 0, 0.03), this->linear(0.115, 0) + (D == 3 ? 30 : 0), 1e-8);
}

TYPED_TEST(PressureSensorOf, MaximumOfAPointIsThePoint) {
  this->set_linear();
  EXPECT_EQ(this->highest(0, 0.043, 0), this->read(0, 0.043, 0));
}

TYPED_TEST(PressureSensorOf, MeansThePressureAndNotThePoint) {
  // p = 9 (y/l0)^2 Pa with a fit that is exact in the mean: over y from 4 to 6 l0 the mean is 9 (25 + 1/3), less the
  // l0/2 midpoints' 9/48; the fit itself adds its smoothing of a parabola, as at the point.
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](const Vec<D>& r, double& p) { p = 9 * r[1] * r[1] / (l0 * l0); });
  EXPECT_NEAR(this->read(0, 5 * l0, 2 * l0) - this->read(0, 5 * l0, 0), 3 - 9. / 48, 0.15);
}

TYPED_TEST(PressureSensorOf, DryWallReadsZero) {
  EXPECT_EQ(this->read(0, 0.105, 0), 0) << "where the linear fit goes on below 0";
  EXPECT_EQ(this->read(0, 0.14, 0), 0);
  EXPECT_EQ(this->highest(0, 0.14, 0.02), 0);
  // Of the area from 0.09 to 0.11 the lower half is wet, at 49 Pa in the mean.
  EXPECT_NEAR(this->read(0, 0.1, 0.02), 0.5 * this->tank.weight * 0.005, 1e-8);
}

}  // namespace
}  // namespace seiche::solver
