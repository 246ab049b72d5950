#include <gtest/gtest.h>

#include "solver/sensors.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct WaveGaugeOf : ::testing::Test {
  static constexpr int D = T::D;
  Parameters p = test::small_tank<D>();
  State<D> s = fill_tank<D>(p);

  /// A gauge at x, midway across.
  double level(double x) const {
    Vec<D> foot = Vec<D>::Constant(0.06);
    foot[0] = x;
    foot[1] = 0;
    return WaveGauge<D>(foot, p.tank.height, l0).level(s);
  }
  void add_drop(double x, double y) {
    Vec<D> r = Vec<D>::Constant(0.065);
    r[0] = x;
    r[1] = y;
    s.add(r, Kind::fluid, Vec<D>::Zero());
  }
};
TYPED_TEST_SUITE(WaveGaugeOf, test::Dimensions);

TYPED_TEST(WaveGaugeOf, ReadsTheDepthOfALatticeAtRest) {
  for (double x : {0., 0.2, 0.1, 0.101, 0.1025, 0.105, 0.1075, 0.109})
    EXPECT_NEAR(this->level(x), 0.1, 0.05 * l0) << "x = " << x;
}

TYPED_TEST(WaveGaugeOf, FollowsARiseFinerThanTheSpacing) {
  for (double x : {0., 0.1, 0.105, 0.2}) {
    const double still = this->level(x);
    for (int tenths = 1; tenths <= 10; ++tenths) {
      State<TypeParam::D> before = this->s;
      for (std::size_t i = 0; i < this->s.size(); ++i)
        if (this->s.kind[i] == Kind::fluid) this->s.position[i][1] += 0.1 * tenths * l0;
      EXPECT_NEAR(this->level(x), still + 0.1 * tenths * l0, 0.05 * l0) << "x = " << x << ", " << tenths;
      this->s = before;
    }
  }
}

TYPED_TEST(WaveGaugeOf, DoesNotCountALoneDropAbove) {
  const double still = this->level(0.105);
  this->add_drop(0.105, 0.135);
  EXPECT_NEAR(this->level(0.105), still, 1e-12);
}

TYPED_TEST(WaveGaugeOf, DoesNotCountALoneDropAtAWall) {
  for (double x : {0., 0.2}) {
    const double still = this->level(x);
    this->add_drop(x == 0 ? 0.005 : 0.195, 0.135);
    EXPECT_NEAR(this->level(x), still, 1e-12) << "x = " << x;
  }
}

TYPED_TEST(WaveGaugeOf, CountsTheHighestOfTwoSurfaces) {
  // A slab of water three layers thick held above an air gap.
  for (std::size_t i = 0; i < this->s.size(); ++i)
    if (this->s.kind[i] == Kind::fluid && this->s.position[i][1] > 0.07) this->s.position[i][1] += 0.04;
  EXPECT_NEAR(this->level(0.1), 0.14, 0.05 * l0);
}

TYPED_TEST(WaveGaugeOf, ReadsZeroOnADryFloor) {
  for (std::size_t i = 0; i < this->s.size(); ++i)
    if (this->s.kind[i] == Kind::fluid) this->s.position[i][0] = 0.05;
  EXPECT_EQ(this->level(0.1), 0);
}

TYPED_TEST(WaveGaugeOf, ReadsTheRoofOfAFullTank) {
  this->p.fluid.depth = this->p.tank.height;
  this->s = fill_tank<TypeParam::D>(this->p);
  for (double x : {0., 0.1, 0.2}) EXPECT_NEAR(this->level(x), 0.15, 1e-12);
}

}  // namespace
}  // namespace seiche::solver
