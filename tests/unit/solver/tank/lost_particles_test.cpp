#include "solver/tank/lost_particles.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D>
Parameters tank(bool closed) {
  Parameters p = test::small_tank<D>();
  p.tank.closed = closed;
  return p;
}

template <class T>
struct LostParticles : ::testing::Test {};
TYPED_TEST_SUITE(LostParticles, test::Dimensions);

TYPED_TEST(LostParticles, AreNoneInAStillTank) {
  constexpr int D = TypeParam::D;
  const Parameters p = tank<D>(true);
  State<D> s = fill_tank<D>(p);
  const auto before = s.id;
  const Lost lost = take_out_lost(*make_shape<D>(p), p.particles.spacing, s);
  EXPECT_EQ(lost.leaked, 0);
  EXPECT_EQ(lost.spilled, 0);
  EXPECT_EQ(s.id, before) << "walls and dummies stand outside, and stay";
}

TYPED_TEST(LostParticles, AreTakenOutAndCountedByTheWayTheyLeft) {
  constexpr int D = TypeParam::D;
  const Parameters p = tank<D>(false);
  State<D> s = fill_tank<D>(p);
  const auto all = s.size();
  s.position[3][1] = -1;                                       // through the floor
  s.position[5][0] = -1;                                       // through a wall
  s.position[8] += Vec<D>::Unit(0) * 1 + Vec<D>::Unit(1) * 1;  // over the rim
  const Lost lost = take_out_lost(*make_shape<D>(p), p.particles.spacing, s);
  EXPECT_EQ(lost.leaked, 2);
  EXPECT_EQ(lost.spilled, 1);
  ASSERT_EQ(s.size(), all - 3);
  EXPECT_EQ((std::vector<std::uint32_t>(s.id.begin(), s.id.begin() + 7)),
            (std::vector<std::uint32_t>{0, 1, 2, 4, 6, 7, 9}));
}

template <class T, int D = T::D>
struct LossOf : ::testing::Test {
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
