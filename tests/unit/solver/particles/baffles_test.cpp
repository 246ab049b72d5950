#include "solver/particles/baffles.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

/// Both sides of a plate from (0, 0) to (0, 1): liquid stands before the first at x > 0.
Baffles<2> plate() {
  return Baffles<2>({BaffleFace<2>({0, 0}, {0, 1}, false, true), BaffleFace<2>({0, 1}, {0, 0}, true, false)});
}

TEST(Baffles, AWayEntersTheSideThatItMeetsFirst) {
  const Baffles<2> baffles = plate();
  EXPECT_EQ(baffles.entered({0.1, 0.5}, {-0.1, 0.5}), 0);
  EXPECT_EQ(baffles.entered({-0.1, 0.5}, {0.1, 0.5}), 1);
  EXPECT_EQ(baffles.entered({0.1, 0.9}, {-0.1, 1.2}), -1) << "over the rim";
  EXPECT_EQ(baffles.entered({0.1, 0.9}, {-0.1, 1.05}), 0);
  EXPECT_EQ(baffles.entered({0.1, 0.5}, {0.01, 0.6}), -1) << "before it";
  // A second plate, at x = -1.
  std::vector<BaffleFace<2>> faces = baffles.faces();
  faces.emplace_back(Vec<2>(-1, 0), Vec<2>(-1, 1), false, true);
  EXPECT_EQ(Baffles<2>(faces).entered({1, 0.5}, {-2, 0.5}), 0);
  EXPECT_EQ(Baffles<2>(faces).entered({-0.5, 0.5}, {-2, 0.5}), 2);
}

TEST(Baffles, BothSidesOfAPlateAgreeAtItsRim) {
  const Baffles<2> baffles = plate();
  EXPECT_EQ(baffles.entered({0.1, 0.9}, {-0.1, 1.1}), -1);
  EXPECT_EQ(baffles.entered({-0.1, 1.1}, {0.1, 0.9}), -1);
  EXPECT_EQ(baffles.entered({-0.1, 0.1}, {0.1, -0.1}), 1) << "at its other end it goes on";
}

TEST(Baffles, LiquidSeesLiquidWhereNothingIsBetween) {
  const Baffles<2> baffles = plate();
  EXPECT_FALSE(baffles.sees({0.1, 0.5}, {-0.1, 0.5}));
  EXPECT_FALSE(baffles.sees({-0.1, 0.5}, {0.1, 0.5}));
  EXPECT_TRUE(baffles.sees({0.1, 0.5}, {0.2, 0.5}));
  EXPECT_TRUE(baffles.sees({0.1, 0.9}, {-0.1, 1.2}));
}

TEST(Baffles, ASolidIsSeenThroughItsOwnSideAlone) {
  const Baffles<2> baffles = plate();
  const Vec<2> right(0.1, 0.5), left(-0.1, 0.5);
  // The solid behind side 0 stands where the liquid of the left is.
  EXPECT_TRUE(baffles.sees(right, -1, {-0.05, 0.5}, 0));
  EXPECT_FALSE(baffles.sees(left, -1, {-0.05, 0.5}, 0));
  EXPECT_TRUE(baffles.sees({-0.05, 0.5}, 0, right, -1)) << "whichever comes first";
  EXPECT_TRUE(baffles.sees(right, -1, {-0.1, 1.02}, 0)) << "also past the rim, through the side";
  EXPECT_FALSE(baffles.sees({0.1, 0.99}, -1, {-0.1, 1.2}, 0)) << "there liquid is seen";
  EXPECT_TRUE(baffles.sees({-0.05, 0.5}, 0, {-0.1, 0.7}, 0));
  EXPECT_FALSE(baffles.sees({-0.05, 0.5}, 0, {0.05, 0.5}, 1)) << "no liquid stands before both";
}

TEST(Baffles, SolidsOfACornerSeeEachOther) {
  // The corner at the origin is open to x > 0, y > 0.
  const Baffles<2> baffles({BaffleFace<2>({0, 0}, {0, 1}, false, false), BaffleFace<2>({1, 0}, {0, 0}, false, false)});
  EXPECT_TRUE(baffles.sees({-0.1, 0.1}, 0, {0.1, -0.1}, 1));
  EXPECT_FALSE(baffles.sees({-0.1, 0.1}, 0, {-0.1, -0.1}, 1)) << "beyond the corner each has its own";
}

TEST(Baffles, KnowWhatIsNearThemAndAtAPlatesRim) {
  const Baffles<2> baffles = plate();
  EXPECT_TRUE(baffles.is_near({0.2, 0.5}, 0.21));
  EXPECT_FALSE(baffles.is_near({0.2, 0.5}, 0.19));
  EXPECT_TRUE(baffles.is_at_rim({0.03, 1.04}, 0.051));
  EXPECT_FALSE(baffles.is_at_rim({0.03, 1.04}, 0.049));
  EXPECT_FALSE(baffles.is_at_rim({0.03, 0.5}, 0.1));
  EXPECT_FALSE(Baffles<2>({BaffleFace<2>({0, 0}, {0, 1}, false, false)}).is_at_rim({0, 1}, 0.1))
      << "where there is none";
}

/// A square of side 2 about the origin in the plane x = 0, with a round hole of radius 1/2.
BaffleFace<3> holed() {
  return {FlatSide(Vec<3>::Zero(), Vec<3>::UnitY(), Vec<3>::UnitZ(), Vec<3>::UnitX(),
                   {{1, 1}, 0, {{Vec<2>::Zero(), 0.5}}}, true)};
}

TEST(Baffles, HaveHolesIn3D) {
  const BaffleFace<3> face = holed();
  const Baffles<3> baffles({face});
  EXPECT_EQ(baffles.entered({-0.1, 0.7, 0}, {0.1, 0.7, 0}), 0);
  EXPECT_EQ(baffles.entered({0.1, 0.7, 0}, {-0.1, 0.7, 0}), -1) << "from behind";
  EXPECT_EQ(baffles.entered({-0.1, 0.3, 0.2}, {0.1, 0.3, 0.2}), -1) << "through the hole";
  EXPECT_EQ(baffles.entered({-0.1, 1.1, 0}, {0.1, 1.1, 0}), -1) << "beside it";
  EXPECT_LT((face.nearest({3, 0.4, 0}) - Vec<3>(0, 0.5, 0)).norm(), 1e-12);
  EXPECT_LT((face.nearest({3, 0.7, 0}) - Vec<3>(0, 0.7, 0)).norm(), 1e-12);
  EXPECT_TRUE(baffles.is_at_rim({0, 0.8, 0}, 0.201));
  EXPECT_FALSE(baffles.is_at_rim({0, 0.8, 0}, 0.199));
  EXPECT_TRUE(baffles.is_near({0.3, 0.1, 0}, 0.501)) << "hypot(0.3, 0.4)";
  EXPECT_FALSE(baffles.is_near({0.3, 0.1, 0}, 0.499));
}

TEST(Baffles, AreRoundAtTheRimOfAThickDisc) {
  const RoundSide rim{Vec<3>::Zero(), Vec<3>::UnitY(), 1, 0.1, false};
  const Baffles<3> baffles({{rim}});
  EXPECT_NEAR(rim.behind({0.6, 5, 0.6}), 1 - std::hypot(0.6, 0.6), 1e-12);
  EXPECT_EQ(baffles.entered({1.1, 0, 0}, {0.9, 0.05, 0}), 0);
  EXPECT_EQ(baffles.entered({1.1, 0, 0}, {0.9, 0.3, 0}), -1) << "above it";
  EXPECT_EQ(baffles.entered({0.9, 0, 0}, {1.1, 0, 0}), -1) << "from within";
  EXPECT_EQ(baffles.entered({0.8, 0, 0.8}, {0.8, 0, -0.8}), 0) << "from before it to before it, through it";
  EXPECT_EQ(baffles.entered({1.01, 0, 0.8}, {1.01, 0, -0.8}), -1);
  EXPECT_NEAR(rim.entry({1.1, 0, 0}, {0.9, 0, 0}, 1), 0.5, 1e-12);
  EXPECT_LT((rim.normal_at({0.3, 0, 0.4}) - Vec<3>(-0.6, 0, -0.8)).norm(), 1e-12) << "into the disc";
}

TEST(Baffles, AreRoundAroundAHoleThroughAThickOne) {
  const RoundSide rim{Vec<3>::Zero(), Vec<3>::UnitY(), 1, 0.1, true};
  const Baffles<3> baffles({{rim}});
  EXPECT_EQ(baffles.entered({0.9, 0, 0}, {1.1, 0, 0}), 0);
  EXPECT_EQ(baffles.entered({1.1, 0, 0}, {0.9, 0, 0}), -1);
  EXPECT_EQ(baffles.entered({0.9, -0.2, 0}, {0.9, 0.2, 0}), -1) << "through the hole";
  EXPECT_EQ(baffles.entered({1.1, 0.3, 0}, {-1.1, -0.3, 0}), -1) << "slantwise through it: beyond its wall there";
  EXPECT_LT((rim.normal_at({0.3, 0, 0.4}) - Vec<3>(0.6, 0, 0.8)).norm(), 1e-12);
}

}  // namespace
}  // namespace seiche::solver
