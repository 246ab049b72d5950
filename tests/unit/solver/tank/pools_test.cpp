#include "solver/tank/pools.hpp"

#include <gtest/gtest.h>

#include "solver/make_simulation.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

/// 0.5 m long, with a divider 0.01 m thick in its middle, as high as told.
Parameters divided(double top, double left, double right) {
  Parameters p;
  p.tank.length = 0.5;
  p.tank.height = 0.4;
  p.tank.baffles = {{.points = {{0.25, -0.1}, {0.25, top}}, .thickness = 0.01}};
  p.fluid.seeds = {{.x = 0.1, .y = 0.02, .z = 0, .depth = left}, {.x = 0.4, .y = 0.02, .z = 0, .depth = right}};
  p.fluid.depth = std::max(left, right);
  p.particles.spacing = 0.01;
  return p;
}

TEST(Pools, AreAllThatLiesBelowTheLevelWithoutSeeds) {
  Parameters p = divided(0.5, 0.2, 0.2);
  p.fluid.seeds.clear();
  const auto pools = pools_of(p, *make_shape<2>(p));
  ASSERT_EQ(pools.size(), 1U);
  EXPECT_NEAR(pools[0].volume, 0.49 * 0.2, 1e-12);
  EXPECT_NEAR(liquid_volume(p), 0.49 * 0.2, 1e-12);
}

TEST(Pools, AreEachWhatIsOpenToItsSeed) {
  const Parameters p = divided(0.5, 0.2, 0.1);
  const auto pools = pools_of(p, *make_shape<2>(p));
  ASSERT_EQ(pools.size(), 2U);
  EXPECT_NEAR(pools[0].volume, 0.245 * 0.2, 1e-4 * 0.05);
  EXPECT_NEAR(pools[1].volume, 0.245 * 0.1, 1e-4 * 0.05);
  for (const auto& part : pools[0].parts) EXPECT_LT(part.inside.centroid[0], 0.245);
  for (const auto& part : pools[1].parts) EXPECT_GT(part.inside.centroid[0], 0.255);
  EXPECT_EQ(level_beside(pools, Vec<2>(0.1, 0.3)), 0.2);
  EXPECT_EQ(level_beside(pools, Vec<2>(0.27, 0.3)), 0.1);
  EXPECT_NEAR(liquid_volume(p), 0.245 * 0.3, 1e-4 * 0.05);
}

TEST(Pools, OfLeaningTanksAreLevel) {
  Parameters p;
  p.tank.length = 0.5;
  p.tank.height = 0.4;
  p.fluid.depth = 0.25;
  p.particles.spacing = 0.01;
  p.gravity = Gravity({1.7, -9.66, 0});  // leans by 10 degrees
  const auto pools = pools_of(p, *make_shape<2>(p));
  const LevelAxes<2> axes(p.gravity);
  double share = 0;
  for (const auto& part : pools[0].parts) {
    share += part.inside.share;
    EXPECT_LT(axes.height(part.inside.centroid), pools[0].level);
  }
  EXPECT_NEAR(share * 1e-4, pools[0].volume, 1e-3 * pools[0].volume);
}

std::string error_of(const Parameters& p) {
  try {
    make_simulation(p, 0);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "no error";
}

TEST(Pools, ThatMeetAreRefused) {
  EXPECT_EQ(error_of(divided(0.5, 0.2, 0.1)), "no error");
  EXPECT_TRUE(test::tells(error_of(divided(0.15, 0.2, 0.1)),
                          {"[[fluid.seed]]", "(0.1, 0.02)", "(0.4, 0.02)", "0.2 m", "0.1 m", "lower"}));
}

TEST(Pools, NeedTheirSeedsInTheTankBelowTheLevel) {
  Parameters p = divided(0.5, 0.2, 0.1);
  p.fluid.seeds[1].x = 0.6;
  EXPECT_TRUE(test::tells(error_of(p), {"[[fluid.seed]]", "(0.6, 0.02)", "outside"}));
  p.fluid.seeds[1] = {.x = 0.4, .y = 0.12, .z = 0, .depth = 0.1};
  EXPECT_TRUE(test::tells(error_of(p), {"[[fluid.seed]]", "(0.4, 0.12)", "0.12 m", "depth = 0.1"}));
  p.fluid.seeds[1] = {.x = 0.4, .y = 0.02, .z = 0.1, .depth = 0.1};
  EXPECT_TRUE(test::tells(error_of(p), {"[[fluid.seed]]", "z = 0.1", "2-D"}));
}

}  // namespace
}  // namespace seiche::solver
