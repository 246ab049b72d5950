#include <gtest/gtest.h>

#include "solver/tank/tank.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T, int D = T::D>
struct BoxOf : ::testing::Test {
  Box<D> closed{parameters(true)}, open{parameters(false)};
  Vec<D> middle = 0.5 * closed.size;

  static Parameters parameters(bool closed) {
    Parameters p = test::small_tank<D>();
    p.tank.closed = closed;
    return p;
  }
  /// The tank's middle, but for one coordinate.
  Vec<D> at(int axis, double value) const {
    Vec<D> r = middle;
    r[axis] = value;
    return r;
  }
};
TYPED_TEST_SUITE(BoxOf, test::Dimensions);

TYPED_TEST(BoxOf, LeaksThroughEveryWallPastTheWallParticles) {
  constexpr double slack = 0.5 * l0, little = 1e-9;
  for (int a = 0; a < TypeParam::D; ++a) {
    const double end = this->closed.size[a];
    EXPECT_FALSE(this->closed.has_leaked(this->at(a, -slack + little))) << a;
    EXPECT_TRUE(this->closed.has_leaked(this->at(a, -slack - little))) << a;
    EXPECT_FALSE(this->closed.has_leaked(this->at(a, end + slack - little))) << a;
    EXPECT_TRUE(this->closed.has_leaked(this->at(a, end + slack + little))) << a;
    EXPECT_EQ(this->open.has_leaked(this->at(a, -l0)), true) << a;
    EXPECT_EQ(this->open.has_leaked(this->at(a, end + l0)), a != 1) << a;
  }
}

TYPED_TEST(BoxOf, SpillsOverTheRimOfAnOpenTankOnly) {
  for (int a = 0; a < TypeParam::D; ++a) {
    if (a == 1) continue;
    for (double beside : {-l0, this->open.size[a] + l0}) {
      auto r = this->at(a, beside);
      r[1] = this->open.size[1] + 0.1 * l0;
      EXPECT_TRUE(this->open.has_spilled(r)) << a;
      EXPECT_FALSE(this->open.has_leaked(r)) << a;
      EXPECT_FALSE(this->closed.has_spilled(r)) << a;
      EXPECT_TRUE(this->closed.has_leaked(r)) << a;
      r[1] = this->open.size[1] - 0.1 * l0;
      EXPECT_FALSE(this->open.has_spilled(r)) << a;
      EXPECT_TRUE(this->open.has_leaked(r)) << a;
    }
  }
}

TYPED_TEST(BoxOf, HoldsWhatFliesAboveAnOpenTank) {
  const auto r = this->at(1, 100 * this->open.size[1]);
  EXPECT_FALSE(this->open.has_spilled(r));
  EXPECT_FALSE(this->open.has_leaked(r));
  EXPECT_TRUE(this->closed.has_leaked(r));
}

TEST(Box, DiagonalIsThatOfTheInnerBox) {
  Parameters p;
  p.tank.length = 0.3;
  p.tank.height = 0.4;
  EXPECT_DOUBLE_EQ(Box<2>(p).diagonal(), 0.5);
  p.tank.width = 1.2;
  EXPECT_DOUBLE_EQ(Box<3>(p).diagonal(), 1.3);
}

}  // namespace
}  // namespace seiche::solver
