#include "solver/tank/shapes/head.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/tank/shapes/path.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;

TEST(Head, AnEllipseOfArcsIsWithinAMillionthOfTheRadius) {
  const double radius = 0.7;
  const std::vector<Edge> edges = head_profile(Head::elliptical, radius, 0);
  double worst = 0;
  for (const Edge& edge : edges)
    for (int k = 0; k <= 20; ++k) {
      // Its distance from the ellipse to first order: value of the equation over the length of its gradient.
      const Vec<2> r = edge.point(k / 20.) / radius;
      const double value = r[0] * r[0] + 4 * r[1] * r[1] - 1, slope = std::hypot(2 * r[0], 8 * r[1]);
      worst = std::max(worst, std::abs(value / slope));
    }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LE(edges.size(), 60u);
  EXPECT_NEAR(edges.back().to[1], 0.5 * radius, 1e-15);
}

TEST(Head, IsSmoothAndJoinsTheShellSmoothly) {
  for (const Head head : {Head::hemispherical, Head::elliptical, Head::torispherical}) {
    const std::vector<Edge> edges = head_profile(head, 0.3, 0);
    EXPECT_LT((edges.front().from - Vec<2>(0.3, 0)).norm(), 1e-15);
    EXPECT_LT((edges.front().normal(0) - Vec<2>(1, 0)).norm(), 1e-12);
    EXPECT_LT((edges.back().normal(1) - Vec<2>(0, 1)).norm(), 1e-9);
    EXPECT_EQ(edges.back().to[0], 0);
    for (std::size_t k = 1; k < edges.size(); ++k) {
      EXPECT_LT((edges[k].from - edges[k - 1].to).norm(), 1e-15);
      EXPECT_LT(std::abs(turn_between(edges[k - 1], edges[k])), 1e-9);
    }
  }
}

TEST(Head, OfKloepperHasItsRadiiAndHeight) {
  const std::vector<Edge> edges = head_profile(Head::torispherical, 0.5, 0);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_NEAR(edges[0].radius(), 0.1, 1e-12);
  EXPECT_NEAR(edges[1].radius(), 1, 1e-12);
  EXPECT_NEAR(edges[1].to[1], 0.19377, 1e-5) << "0.1938 diameters";
  EXPECT_NEAR(edges[1].centre()[0], 0, 1e-12);
}

TEST(Biarc, OfTheEndsOfACircleIsThatCircle) {
  for (const Edge& edge : biarc({1, 0}, {0, 1}, {0, 1}, {-1, 0}, 3)) {
    EXPECT_NEAR(edge.radius(), 1, 1e-12);
    EXPECT_NEAR(edge.centre().norm(), 0, 1e-12);
    EXPECT_EQ(edge.patch, 3);
  }
}

}  // namespace
}  // namespace seiche::solver
