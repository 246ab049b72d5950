#include "solver/tank/losses.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct LossOf : ::testing::Test {
  static constexpr int D = T::D;
  static std::shared_ptr<const Shape<D>> tank(bool closed) {
    Parameters p = test::small_tank<D>();
    p.tank.closed = closed;
    return make_shape<D>(p);
  }
  std::shared_ptr<const Shape<D>> closed = tank(true), open = tank(false);
  Vec<D> high = closed->bounds().high;

  /// The tank's middle, but for one coordinate.
  Vec<D> at(int axis, double value) const {
    Vec<D> r = 0.5 * high;
    r[axis] = value;
    return r;
  }
  Loss in_closed(const Vec<D>& r) const { return loss_of(r, *closed, l0); }
  Loss in_open(const Vec<D>& r) const { return loss_of(r, *open, l0); }
};
TYPED_TEST_SUITE(LossOf, test::Dimensions);

TYPED_TEST(LossOf, LeaksThroughEveryWallPastTheWallParticles) {
  constexpr double slack = 0.5 * l0, little = 1e-9;
  for (int a = 0; a < TypeParam::D; ++a) {
    const double end = this->high[a];
    EXPECT_EQ(this->in_closed(this->at(a, -slack + little)), Loss::none) << a;
    EXPECT_EQ(this->in_closed(this->at(a, -slack - little)), Loss::leaked) << a;
    EXPECT_EQ(this->in_closed(this->at(a, end + slack - little)), Loss::none) << a;
    EXPECT_EQ(this->in_closed(this->at(a, end + slack + little)), Loss::leaked) << a;
    EXPECT_EQ(this->in_open(this->at(a, -l0)), Loss::leaked) << a;
    EXPECT_EQ(this->in_open(this->at(a, end + l0)), a == 1 ? Loss::none : Loss::leaked) << a;
  }
}

TYPED_TEST(LossOf, SpillsOverTheRimOfAnOpenTankOnly) {
  for (int a = 0; a < TypeParam::D; ++a) {
    if (a == 1) continue;
    for (double beside : {-l0, this->high[a] + l0}) {
      auto r = this->at(a, beside);
      r[1] = this->high[1] + 0.1 * l0;
      EXPECT_EQ(this->in_open(r), Loss::spilled) << a;
      EXPECT_EQ(this->in_closed(r), Loss::leaked) << a;
      r[1] = this->high[1] - 0.1 * l0;
      EXPECT_EQ(this->in_open(r), Loss::leaked) << a;
    }
  }
}

TYPED_TEST(LossOf, IsNoneOfWhatFliesAboveAnOpenTank) {
  const auto r = this->at(1, 100 * this->high[1]);
  EXPECT_EQ(this->in_open(r), Loss::none);
  EXPECT_EQ(this->in_closed(r), Loss::leaked);
}

}  // namespace
}  // namespace seiche::solver
