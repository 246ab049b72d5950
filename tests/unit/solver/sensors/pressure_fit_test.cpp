#include "solver/sensors/pressure_fit.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

template <class T, int D = T::D>
struct PressureFit : ::testing::Test {
  SensedTank<D> tank;
  double at_floor = 1000 * 9.81 * 0.1;

  LinearPressure<D> fit(const Vec<D>& point) const { return fit_pressure<D>(point, point, l0, tank.s, tank.cells()); }
  double read(const Vec<D>& point) const { return fit(point).value; }
};
TYPED_TEST_SUITE(PressureFit, test::Dimensions);

TYPED_TEST(PressureFit, IsExactOnStillWaterInACornerAndOnEveryWall) {
  constexpr int D = TypeParam::D;
  EXPECT_NEAR(this->read(Vec<D>::Zero()), this->at_floor, 1e-8);
  for (double x : {0., 0.003, 0.1, 0.2})
    for (double y : {0., 0.004, 0.05, 0.09}) {
      const LinearPressure<D> fit = this->fit(this->tank.at(x, y));
      EXPECT_NEAR(fit.value, this->at_floor * (1 - y / 0.1), 1e-8) << x << ' ' << y;
      EXPECT_LT((fit.slope + this->tank.weight * Vec<D>::Unit(1)).norm(), 1e-8 * this->tank.weight) << x << ' ' << y;
    }
}

TYPED_TEST(PressureFit, IsExactOnAnyLinearFieldOfADisorderedCloud) {
  constexpr int D = TypeParam::D;
  this->tank.s = test::disordered<D>(test::block<D>(7), 0.2 * l0);
  this->tank.each_fluid([](const Vec<D>& r, double& p) { p = 100 + test::slanted<D>().dot(r) / l0; });
  for (double x : {-3., -1.3, 0., 3.}) {
    const Vec<D> point = x * l0 * Vec<D>::Ones();
    EXPECT_NEAR(this->read(point), 100 + x * test::slanted<D>().sum(), 1e-10);
  }
}

TYPED_TEST(PressureFit, ReadsTheFluidOnly) {
  constexpr int D = TypeParam::D;
  for (std::size_t i = 0; i < this->tank.s.size(); ++i)
    if (this->tank.s.kind[i] != Kind::fluid) this->tank.s.pressure[i] = 1e9;
  EXPECT_NEAR(this->read(Vec<D>::Zero()), this->at_floor, 1e-8);
}

TYPED_TEST(PressureFit, IsTheMeanOfWhatLiesInALine) {
  constexpr int D = TypeParam::D;
  this->tank.s = {};
  const Vec<D> middle = this->tank.at(0.1, 0.05);
  for (double x : {-1., 1.}) {
    this->tank.s.add(middle + x * l0 * Vec<D>::Unit(0), Kind::fluid, Vec<D>::Zero());
    this->tank.s.pressure.back() = 50 + 10 * x;
  }
  EXPECT_NEAR(this->read(middle), 50, 1e-10);
  this->tank.s.position[1][0] += l0;
  const KF3 w{3};
  EXPECT_NEAR(this->read(middle), (40 * w(1) + 60 * w(2)) / (w(1) + w(2)), 1e-10);
  EXPECT_EQ(this->fit(middle).slope, (Vec<D>(Vec<D>::Zero())));
}

TYPED_TEST(PressureFit, ReadsNothingInTheAir) { EXPECT_EQ(this->read(this->tank.at(0, 0.14)), 0); }

}  // namespace
}  // namespace seiche::solver
