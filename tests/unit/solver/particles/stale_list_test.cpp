#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

constexpr double skin = 0.3 * test::l0;

struct StaleList : ::testing::Test {
  State<2> s = test::block<2>(7);
  Neighbours<2> list = test::listed(s, 2.1 * test::l0, skin);
};

TEST_F(StaleList, IsTrueBeforeItIsMade) {
  Neighbours<2> empty(Vec<2>::Zero(), Vec<2>::Ones(), 0.1, 0.01);
  State<2> fresh = test::block<2>(3);
  EXPECT_TRUE(empty.is_stale(fresh));
}

TEST_F(StaleList, BeginsWhereOneParticleHasMovedByTheSkin) {
  EXPECT_FALSE(list.is_stale(s));
  s.position[20] += Vec<2>(0, 0.999 * skin);
  EXPECT_FALSE(list.is_stale(s));
  s.position[20] += Vec<2>(0, 0.002 * skin);
  EXPECT_TRUE(list.is_stale(s));
  list.build(s);
  EXPECT_FALSE(list.is_stale(s));
}

TEST_F(StaleList, BeginsWhereTwoHaveMovedTowardsEachOtherByHalfOfIt) {
  s.position[20] += Vec<2>(0.51 * skin, 0);
  EXPECT_FALSE(list.is_stale(s));
  s.position[23] -= Vec<2>(0.51 * skin, 0);
  EXPECT_TRUE(list.is_stale(s));
}

TEST_F(StaleList, CountsTheWholeWayNotOneStep) {
  for (int step = 0; step < 6; ++step) {
    EXPECT_EQ(list.is_stale(s), step > 5) << step;
    s.position[0] += Vec<2>(-0.18 * skin, 0);
  }
  EXPECT_TRUE(list.is_stale(s));
}

TEST_F(StaleList, LetsAllMoveTogetherUpToTheLengthOfACell) {
  const double far = 0.5 * 2.1 * test::l0 + skin;
  for (auto& r : s.position) r += Vec<2>(0.999 * far, 0);
  EXPECT_FALSE(list.is_stale(s));
  for (auto& r : s.position) r += Vec<2>(0.002 * far, 0);
  EXPECT_TRUE(list.is_stale(s));
}

TEST_F(StaleList, FollowsTheNumberOfParticles) {
  s.reorder({0, 1, 2});
  EXPECT_TRUE(list.is_stale(s));
}

TEST_F(StaleList, HoldsEveryPairUntilThen) {
  std::mt19937_64 random(3);
  // All together, and half the skin at random.
  for (auto& r : s.position) r += Vec<2>(3 * skin, 0) + 0.5 * skin * test::random_vec<2>(random, -1, 1) / std::sqrt(2);
  ASSERT_FALSE(list.is_stale(s));
  int new_pairs = 0;
  for (int i = 0; i < static_cast<int>(s.size()); ++i)
    for (int j = 0; j < static_cast<int>(s.size()); ++j) {
      if (i == j || (s.position[j] - s.position[i]).norm() >= list.radius()) continue;
      { EXPECT_TRUE(std::find(list[i].begin(), list[i].end(), j) != list[i].end()) << i << ' ' << j; }
      new_pairs += (s.listed_position[j] - s.listed_position[i]).norm() >= list.radius();
    }
  EXPECT_GT(new_pairs, 0) << "no pair came within the radius: nothing was tested";
}

}  // namespace
}  // namespace seiche::solver
