#include <gtest/gtest.h>

#include "solver/sensors.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct PressureSensor : ::testing::Test {
  static constexpr int D = T::D;
  Parameters p = test::small_tank<D>();
  State<D> s = fill_tank<D>(p);
  double at_floor = 1000 * 9.81 * 0.1;

  Vec<D> at(double x, double y) const {
    Vec<D> r = Vec<D>::Constant(0.06);
    r[0] = x;
    r[1] = y;
    return r;
  }
};
TYPED_TEST_SUITE(PressureSensor, test::Dimensions);

TYPED_TEST(PressureSensor, IsExactOnStillWaterInACornerAndOnEveryWall) {
  constexpr int D = TypeParam::D;
  EXPECT_NEAR(pressure_at<D>(Vec<D>::Zero(), l0, this->s), this->at_floor, 1e-8);
  for (double x : {0., 0.003, 0.1, 0.2})
    for (double y : {0., 0.004, 0.05, 0.09})
      EXPECT_NEAR(pressure_at<D>(this->at(x, y), l0, this->s), this->at_floor * (1 - y / 0.1), 1e-8) << x << ' ' << y;
}

TYPED_TEST(PressureSensor, IsExactOnAnyLinearFieldOfADisorderedCloud) {
  constexpr int D = TypeParam::D;
  auto s = test::disordered<D>(test::block<D>(7), 0.2 * l0);
  for (std::size_t i = 0; i < s.size(); ++i) s.pressure[i] = 100 + test::slanted<D>().dot(s.position[i]) / l0;
  for (double x : {-3., -1.3, 0., 3.}) {
    const Vec<D> point = x * l0 * Vec<D>::Ones();
    EXPECT_NEAR(pressure_at<D>(point, l0, s), 100 + x * test::slanted<D>().sum(), 1e-10);
  }
}

TYPED_TEST(PressureSensor, ReadsTheFluidOnly) {
  constexpr int D = TypeParam::D;
  for (std::size_t i = 0; i < this->s.size(); ++i)
    if (this->s.kind[i] != Kind::fluid) this->s.pressure[i] = 1e9;
  EXPECT_NEAR(pressure_at<D>(Vec<D>::Zero(), l0, this->s), this->at_floor, 1e-8);
}

TYPED_TEST(PressureSensor, IsTheMeanOfWhatLiesInALine) {
  constexpr int D = TypeParam::D;
  State<D> s;
  for (double x : {-1., 1.}) {
    s.add(x * l0 * Vec<D>::Unit(0), Kind::fluid, Vec<D>::Zero());
    s.pressure.back() = 50 + 10 * x;
  }
  EXPECT_DOUBLE_EQ(pressure_at<D>(Vec<D>::Zero(), l0, s), 50);
  s.position[1] *= 2;
  const KF3 w{3};
  EXPECT_NEAR(pressure_at<D>(Vec<D>::Zero(), l0, s), (40 * w(1) + 60 * w(2)) / (w(1) + w(2)), 1e-10);
}

TYPED_TEST(PressureSensor, ReadsNothingInTheAir) {
  constexpr int D = TypeParam::D;
  EXPECT_EQ(pressure_at<D>(this->at(0, 0.14), l0, this->s), 0);
}

}  // namespace
}  // namespace seiche::solver
