#include "solver/tank/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "solver/errors.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

Contour circle(const Vec<2>& centre, double radius) {
  const Vec<2> arm(radius, 0);
  return Contour({{{centre - arm, centre + arm, 1, 0}, {centre + arm, centre - arm, 1, 0}}});
}

// 0.6 x 0.4 with the lower corners cut at 45 degrees over 0.1.
const std::vector<Vec<2>> chamfered{{0.1, 0}, {0.5, 0}, {0.6, 0.1}, {0.6, 0.4}, {0, 0.4}, {0, 0.1}};

TEST(Contour, OfACircleKnowsItsDistanceEverywhere) {
  const Contour tank = circle({0.3, 0.2}, 0.25);
  EXPECT_NEAR(tank.area(), std::numbers::pi * 0.0625, 1e-15);
  EXPECT_NEAR(tank.length(), std::numbers::pi * 0.5, 1e-15);
  EXPECT_NEAR((tank.bounds().low - Vec<2>(0.05, -0.05)).norm(), 0, 1e-15);
  EXPECT_NEAR((tank.bounds().high - Vec<2>(0.55, 0.45)).norm(), 0, 1e-15);
  for (double x = -0.2; x < 0.8; x += 0.073)
    for (double y = -0.3; y < 0.7; y += 0.071) {
      const Vec<2> off = Vec<2>(x, y) - Vec<2>(0.3, 0.2);
      const Nearest<2> wall = tank.nearest({x, y});
      EXPECT_NEAR(wall.distance, off.norm() - 0.25, 1e-12);
      EXPECT_NEAR((wall.normal - off.normalized()).norm(), 0, 1e-9);
      EXPECT_NEAR((wall.foot - Vec<2>(0.3, 0.2) - 0.25 * off.normalized()).norm(), 0, 1e-9);
    }
}

TEST(Contour, MayBeGivenEitherWayRound) {
  std::vector<Vec<2>> corners = chamfered;
  for (const bool turned : {false, true}) {
    const Contour tank = polygon(corners);
    EXPECT_NEAR(tank.area(), 0.6 * 0.4 - 0.01, 1e-15) << turned;
    EXPECT_NEAR(tank.nearest({0.3, 0.05}).distance, -0.05, 1e-15);
    EXPECT_NEAR(tank.nearest({0.02, 0.02}).distance, 0.06 / std::numbers::sqrt2, 1e-15) << "behind the chamfer";
    std::reverse(corners.begin(), corners.end());
  }
  EXPECT_EQ(polygon(chamfered).nearest({0.59, 0.2}).patch, 2);
}

TEST(Contour, WithAHoleHasItsInsideBetween) {
  std::vector<Edge> outer = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).loops()[0];
  std::vector<Edge> inner = polygon({{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}).loops()[0];
  const Contour tank({inner, outer});
  EXPECT_NEAR(tank.area(), 0.96, 1e-15);
  EXPECT_NEAR(tank.nearest({0.5, 0.5}).distance, 0.1, 1e-15);
  EXPECT_NEAR(tank.nearest({0.35, 0.5}).distance, -0.05, 1e-15);
  EXPECT_EQ(tank.nearest({0.35, 0.5}).normal, Vec<2>(1, 0));
  EXPECT_NEAR(tank.nearest({0.35, 0.35}).distance, -0.05 * std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR((tank.nearest({0.35, 0.35}).normal - Vec<2>::Constant(1 / std::numbers::sqrt2)).norm(), 0, 1e-12)
      << "before a corner of the wall it points at that";
}

// Star-shaped polygons, so that the inside is known from the angle.
TEST(Contour, OfAnyPolygonIsFoundAsByBruteForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.3, 1), place(-1.2, 1.2);
  for (int polygon_number = 0; polygon_number < 10; ++polygon_number) {
    std::vector<Vec<2>> corners;
    for (int k = 0; k < 9; ++k)
      corners.emplace_back(radius(random) *
                           Vec<2>(std::cos(k * 2 * std::numbers::pi / 9), std::sin(k * 2 * std::numbers::pi / 9)));
    const Contour tank = polygon(corners);
    for (int sample = 0; sample < 200; ++sample) {
      const Vec<2> r(place(random), place(random));
      double least = 100;
      bool inside = false;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
        for (int m = 0; m <= 4000; ++m) least = std::min(least, (a + m / 4000. * (b - a) - r).norm());
        if (cross(a, r) >= 0 && cross(r, b) > 0) inside = cross(b - a, r - a) > 0;
      }
      const Nearest<2> wall = tank.nearest(r);
      // Its samples lie up to 2.5e-4 from the foot.
      EXPECT_EQ(wall.distance < 0, inside);
      EXPECT_LE(std::abs(wall.distance), least + 1e-12);
      EXPECT_GE(std::hypot(wall.distance, 2.5e-4), least);
      EXPECT_NEAR((r - wall.foot).norm(), std::abs(wall.distance), 1e-12);
      EXPECT_NEAR(wall.normal.norm(), 1, 1e-12);
    }
  }
}

TEST(Contour, OfHundredsOfEdgesFindsTheNearestOfAll) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> radius(0.9, 1), place(-1.2, 1.2);
  std::vector<Vec<2>> corners;
  for (int k = 0; k < 700; ++k)
    corners.emplace_back(radius(random) *
                         Vec<2>(std::cos(k * std::numbers::pi / 350), std::sin(k * std::numbers::pi / 350)));
  const Contour tank = polygon(corners);
  for (int sample = 0; sample < 500; ++sample) {
    const Vec<2> r(place(random), place(random));
    double least = 100;
    for (const Edge& edge : tank.loops()[0]) least = std::min(least, (edge.point(edge.nearest_share(r)) - r).norm());
    EXPECT_EQ(std::abs(tank.nearest(r).distance), least);
  }
}

TEST(Contour, AsAPolygonStaysWithinItsTolerance) {
  const Contour tank = circle({0, 0}, 1);
  const auto corners = tank.polygons(1e-4).at(0);
  double area = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k].position, &b = corners[(k + 1) % corners.size()].position;
    EXPECT_GT((0.5 * (a + b)).norm(), 1 - 1e-4);
    area += 0.5 * cross(a, b);
  }
  EXPECT_NEAR(area, std::numbers::pi, 2 * std::numbers::pi * 1e-4);
  EXPECT_LT(corners.size(), 300u);
}

std::string refusal(const std::vector<Vec<2>>& corners) {
  try {
    polygon(corners);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "taken";
}

TEST(Contour, RefusesAWallThatIsNone) {
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {1, 0}}), {"2 points", "three"}));
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), {"(1, 0) m", "twice"}));
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {1, 0}, {std::nan(""), 1}}), {"finite"}));
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), {"crosses", "(0.5, 0.5) m"})) << "a bow tie";
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), {"crosses"})) << "it folds back on itself";
  EXPECT_TRUE(test::tells(refusal({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}), {"touches"})) << "a corner on an edge";
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), "taken") << "a corner on a straight wall is none";
}

}  // namespace
}  // namespace seiche::solver
