#include "solver/tank/shapes/built_in.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/errors.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
using Names = std::vector<std::string>;

template <class Make>
std::string refusal(Make make) {
  try {
    make();
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "taken";
}

TEST(Prism, KeepsItsOwnCoordinates) {
  const Extruded tank = prism({{1, 2}, {1, 3}, {3, 2}}, 0.5);
  EXPECT_NEAR(tank.volume(), 0.5, 1e-15);
  EXPECT_EQ(tank.bounds().low, Vec<3>(1, 2, 0));
  EXPECT_EQ(tank.bounds().high, Vec<3>(3, 3, 0.5));
  const SurfaceMesh mesh = tank.surface();
  const char* names[] = {"edge_1", "edge_2", "edge_3", "near", "far"};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(mesh.patches.at(k).name, names[k]);
  EXPECT_EQ(tank.nearest({1, 2.5, 0.2}).patch, 0) << "from the first point to the second";
  EXPECT_EQ(tank.nearest({2, 2, 0.2}).patch, 2);
}

TEST(Membrane, HasItsChamfersAndNamesItsSides) {
  const Extruded tank = membrane(38, 27, {3.8, 3.8}, {8.6, 8.6}, 40);
  EXPECT_NEAR(tank.section().area(), 38 * 27 - 3.8 * 3.8 - 8.6 * 8.6, 1e-9);
  EXPECT_LT((tank.bounds().low - Vec<3>(-19, 0, -20)).norm(), 1e-12);
  EXPECT_LT((tank.bounds().high - Vec<3>(19, 27, 20)).norm(), 1e-12);
  const Names names = tank.section().patches();
  EXPECT_EQ(names, (Names{"floor", "lower_right", "right", "upper_right", "roof", "upper_left", "left", "lower_left"}));
  const auto at = [&](double x, double y) { return names.at(static_cast<std::size_t>(tank.nearest({x, y, 0}).patch)); };
  EXPECT_EQ(at(0, 0.1), "floor");
  EXPECT_EQ(at(17, 2), "lower_right");
  EXPECT_EQ(at(18.9, 10), "right");
  EXPECT_EQ(at(-15, 23), "upper_left");
  EXPECT_EQ(at(-17, 2), "lower_left");
}

TEST(Membrane, LeavesOutSidesOfNoLength) {
  EXPECT_EQ(membrane(1, 1, {0, 0}, {0.2, 0.3}, 1).section().patches(),
            (Names{"floor", "right", "upper_right", "roof", "upper_left", "left"}));
  EXPECT_EQ(membrane(1, 0.6, {0.5, 0.3}, {0.2, 0.3}, 1).section().patches(),
            (Names{"lower_right", "upper_right", "roof", "upper_left", "lower_left"}));
}

TEST(Cylinder, HasTheVolumeOfItsShellAndHeads) {
  const double r = 0.3, shell = pi * r * r * 0.8;
  EXPECT_NEAR(cylinder(r, 0.8, Axis::y, Head::flat).volume(), shell, 1e-14);
  EXPECT_NEAR(cylinder(r, 0.8, Axis::x, Head::hemispherical).volume(), shell + 4 * pi / 3 * r * r * r, 1e-14);
  EXPECT_NEAR(cylinder(r, 0.8, Axis::z, Head::elliptical).volume(), shell + 2 * pi / 3 * r * r * r, 1e-7);
  // Kloepper's head holds about 0.1 D^3.
  EXPECT_NEAR((cylinder(r, 0.8, Axis::z, Head::torispherical).volume() - shell) / 2 / (8 * r * r * r), 0.1, 0.002);
}

TEST(Cylinder, StandsOrLiesOnItsLowestPoint) {
  const Revolved upright = cylinder(0.3, 0.8, Axis::y, Head::hemispherical);
  EXPECT_LT((upright.bounds().low - Vec<3>(-0.3, 0, -0.3)).norm(), 1e-15);
  EXPECT_LT((upright.bounds().high - Vec<3>(0.3, 1.4, 0.3)).norm(), 1e-15);
  const Revolved lying = cylinder(0.3, 0.8, Axis::x, Head::elliptical);
  EXPECT_LT((lying.bounds().low - Vec<3>(-0.55, 0, -0.3)).norm(), 1e-15);
  EXPECT_LT((lying.bounds().high - Vec<3>(0.55, 0.6, 0.3)).norm(), 1e-15);
  const Revolved across = cylinder(0.3, 0.8, Axis::z, Head::flat);
  EXPECT_LT((across.bounds().low - Vec<3>(-0.3, 0, -0.4)).norm(), 1e-15);
}

TEST(Cylinder, NamesItsHeadsByWhereTheyAre) {
  EXPECT_EQ(cylinder(0.3, 0.8, Axis::y, Head::flat).patches(), (Names{"shell", "lower_head", "upper_head"}));
  for (const int axis : {0, 1, 2}) {
    const Revolved tank = cylinder(0.3, 0.8, static_cast<Axis>(axis), Head::torispherical);
    Vec<3> end = tank.origin();
    EXPECT_EQ(tank.nearest(end).patch, 1);
    end[axis] = tank.bounds().high[axis];
    EXPECT_EQ(tank.nearest(end).patch, 2);
    EXPECT_NEAR(tank.nearest(end).distance, 0, 1e-14);
  }
}

TEST(Revolve, ClosesItsEndsAndFreesItsLowestPoint) {
  const Revolved cone = revolve({{2, 0}, {5, 1}});
  EXPECT_NEAR(cone.volume(), pi, 1e-12);
  EXPECT_EQ(cone.patches(), (Names{"edge_1", "last_end"}));
  EXPECT_EQ(cone.bounds().low[1], 0);
  EXPECT_EQ(cone.patches().at(static_cast<std::size_t>(cone.nearest({0.2, 3, 0}).patch)), "last_end");
  const Revolved ring = revolve({{0, 1}, {0, 2}, {1, 2}, {1, 1}, {0, 1}});
  EXPECT_NEAR(ring.volume(), 3 * pi, 1e-12);
  EXPECT_NEAR(ring.nearest({0, 0.5, 0}).distance, 1, 1e-15);
}

TEST(BuiltIn, RefusesNumbersThatDontFit) {
  EXPECT_TRUE(test::tells(refusal([] { prism({{0, 0}, {1, 0}, {0, 1}}, 0); }), {"width", "0 m"}));
  EXPECT_TRUE(test::tells(refusal([] { sphere(-1); }), {"radius", "-1 m"}));
  EXPECT_TRUE(test::tells(refusal([] { membrane(1, 1, {0.6, 0.6}, {0, 0}, 1); }), {"lower chamfer", "0.6", "0.5 m"}));
  EXPECT_TRUE(test::tells(refusal([] { membrane(1, 1, {0.4, 0.6}, {0.4, 0.5}, 1); }), {"0.6 and 0.5", "1 m"}));
  EXPECT_TRUE(test::tells(refusal([] { cylinder(1, std::nan(""), Axis::y, Head::flat); }), {"length"}));
  EXPECT_TRUE(test::tells(refusal([] { revolve({{0, 0}, {1, -0.1}, {2, 0}}); }), {"point 2", "-0.1 m"}));
  EXPECT_TRUE(test::tells(refusal([] { revolve({{0, 0}}); }), {"1 points", "two"}));
}

}  // namespace
}  // namespace seiche::solver
