#include "solver/tank/edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

// A quarter of the circle of radius 2 about (1, 1), turning left from its right end to its top.
const Edge quarter{{3, 1}, {1, 3}, std::tan(std::numbers::pi / 8), 0};
// Three quarters of it, turning right.
const Edge rest{{3, 1}, {1, 3}, -std::tan(3 * std::numbers::pi / 8), 0};

TEST(Edge, OfAnArcHasItsRadiusCentreAndLength) {
  for (const Edge& arc : {quarter, rest}) {
    EXPECT_NEAR(arc.radius(), 2, 1e-12);
    EXPECT_NEAR((arc.centre() - Vec<2>(1, 1)).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(quarter.length(), std::numbers::pi, 1e-12);
  EXPECT_NEAR(rest.length(), 3 * std::numbers::pi, 1e-12);
  EXPECT_NEAR((quarter.point(0.5) - Vec<2>(1 + std::numbers::sqrt2, 1 + std::numbers::sqrt2)).norm(), 0, 1e-12);
  EXPECT_NEAR((rest.point(0.5) - Vec<2>(1 - std::numbers::sqrt2, 1 - std::numbers::sqrt2)).norm(), 0, 1e-12);
}

TEST(Edge, HasItsNormalOnTheRight) {
  EXPECT_NEAR((quarter.normal(0) - Vec<2>(1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((quarter.normal(1) - Vec<2>(0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((rest.normal(0) - Vec<2>(-1, 0)).norm(), 0, 1e-12) << "the liquid is outside the circle";
  EXPECT_EQ((Edge{{0, 0}, {2, 0}, 0, 0}).normal(0.3), Vec<2>(0, -1));
}

TEST(Edge, FindsItsNearestPointAsABruteForceSearchDoes) {
  for (const Edge& edge : {quarter, rest, Edge{{3, 1}, {1, 3}, 0, 0}})
    for (double x = -3.1; x < 5; x += 0.7)
      for (double y = -3.2; y < 5; y += 0.7) {
        const Vec<2> r(x, y);
        double least = 100;
        for (int k = 0; k <= 20000; ++k) least = std::min(least, (edge.point(k / 20000.) - r).norm());
        const double found = (edge.point(edge.nearest_share(r)) - r).norm();
        EXPECT_LE(found, least + 1e-12) << x << ' ' << y;
        EXPECT_GE(found, least - 3e-4) << x << ' ' << y;
      }
}

}  // namespace
}  // namespace seiche::solver
