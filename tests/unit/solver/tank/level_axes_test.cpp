#include "solver/tank/level_axes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/tank/level.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

TEST(Gravity, IsUprightAlongMinusYAndWhereThereIsNone) {
  EXPECT_EQ(Gravity(9.81).size(), 9.81);
  EXPECT_TRUE(Gravity(9.81).is_upright());
  EXPECT_TRUE(Gravity(0).is_upright());
  EXPECT_FALSE(Gravity({1, -9, 0}).is_upright());
  EXPECT_FALSE(Gravity({0, 9, 0}).is_upright());
  EXPECT_DOUBLE_EQ(Gravity({2, -3, 6}).size(), 7);
}

TEST(LevelAxes, AreTheTanksOwnInAnUprightTank) {
  const LevelAxes<3> axes(9.81);
  const Vec<3> r(0.1, 0.2, 0.3);
  EXPECT_EQ(axes(r), r);
  EXPECT_EQ(axes.in_tank(r), r);
  EXPECT_EQ(axes.up(), Vec<3>(0, 1, 0));
}

TEST(LevelAxes, HaveYAgainstGravity) {
  const LevelAxes<3> axes(Gravity({3, -4, 12}));
  EXPECT_LT((axes.up() - Vec<3>(-3, 4, -12) / 13).norm(), 1e-15);
  const Vec<3> r(0.1, 0.2, 0.3);
  EXPECT_NEAR(axes(r)[1], axes.up().dot(r), 1e-15);
  EXPECT_NEAR(axes.height(r), axes.up().dot(r), 1e-15);
  EXPECT_NEAR(axes(r).norm(), r.norm(), 1e-15);
  EXPECT_LT((axes.in_tank(axes(r)) - r).norm(), 1e-15);
  const LevelAxes<2> plane(Gravity({3, -4, 0}));
  EXPECT_LT((plane.up() - Vec<2>(-0.6, 0.8)).norm(), 1e-15);
}

TEST(LevelAxes, AreTurnedHalfRoundAboutZInATankOnItsHead) {
  const Gravity upwards({0, 9.81, 0});
  EXPECT_LT((LevelAxes<2>(upwards)(Vec<2>(0.1, 0.2)) - Vec<2>(-0.1, -0.2)).norm(), 1e-15);
  EXPECT_LT((LevelAxes<3>(upwards)(Vec<3>(0.1, 0.2, 0.3)) - Vec<3>(-0.1, -0.2, 0.3)).norm(), 1e-15);
}

TEST(LevelAxes, BoundATank) {
  const auto tank = make_shape<2>(test::small_tank<2>());  // 0.2 m x 0.15 m
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  const Bounds<2> bounds = LevelAxes<2>(Gravity({-9.81 * s, -9.81 * c, 0})).bounds_of(*tank);
  EXPECT_NEAR(bounds.size()[1], 0.2 * s + 0.15 * c, 1e-12);
  EXPECT_NEAR(bounds.size()[0], 0.2 * c + 0.15 * s, 1e-12);
}

TEST(LevelAxes, OfLiquidThatTurnsHaveItsParaboloidsLevel) {
  const RelativeEquilibrium turning{9.81, 5, {0.1, 0, -0.2}};
  const LevelAxes<3> axes(turning);
  const double bend = 5 * 5 / (2 * 9.81);
  for (const Vec<3>& r : {Vec<3>(0.1, 0.2, 0.3), Vec<3>(-0.2, 0.1, -0.3), Vec<3>(0.4, 0, 0.1)}) {
    const double squared = std::pow(r[0] - 0.1, 2) + std::pow(r[2] + 0.2, 2);
    EXPECT_NEAR(axes.height(r), r[1] - bend * squared, 1e-14);
    EXPECT_LT((axes.in_tank(axes(r)) - r).norm(), 1e-15);
  }
}

TEST(LevelAxes, HoldAsMuchOfLiquidThatTurns) {
  const SurfaceMesh wall = sphere(0.25).surface();
  const SurfaceMesh bent = on_level_axes(wall, RelativeEquilibrium{Gravity({2, -3, 6}), 4, {0.1, 0, 0}});
  EXPECT_NEAR(volume_of(bent), volume_of(wall), 1e-3 * volume_of(wall));
}

TEST(LevelAxes, HoldAsMuchInASphereHoweverItLeans) {
  const SurfaceMesh wall = sphere(0.25).surface(), turned = on_level_axes(wall, Gravity({2, -3, 6}));
  EXPECT_NEAR(volume_of(turned), volume_of(wall), 1e-12);
  EXPECT_NEAR(volume_below(turned, turned.low()[1] + 0.1), volume_below(wall, 0.1), 1e-3 * volume_below(wall, 0.1));
}

}  // namespace
}  // namespace seiche::solver
