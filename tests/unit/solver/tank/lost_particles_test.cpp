#include "solver/tank/lost_particles.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

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
  const Lost lost = take_out_lost(Box<D>(p), s);
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
  const Lost lost = take_out_lost(Box<D>(p), s);
  EXPECT_EQ(lost.leaked, 2);
  EXPECT_EQ(lost.spilled, 1);
  ASSERT_EQ(s.size(), all - 3);
  EXPECT_EQ((std::vector<std::uint32_t>(s.id.begin(), s.id.begin() + 7)),
            (std::vector<std::uint32_t>{0, 1, 2, 4, 6, 7, 9}));
}

}  // namespace
}  // namespace seiche::solver
