#include "solver/tank/mesh/cut_cube.hpp"

#include <gtest/gtest.h>

#include <random>

namespace seiche::solver {
namespace {

double counted(const Vec<3>& way, double at) {
  constexpr int parts = 60;
  int below = 0;
  for (int x = 0; x < parts; ++x)
    for (int y = 0; y < parts; ++y)
      for (int z = 0; z < parts; ++z)
        below += way.dot(Vec<3>(x + 0.5, y + 0.5, z + 0.5) / parts - Vec<3>::Constant(0.5)) < at;
  return static_cast<double>(below) / (parts * parts * parts);
}

TEST(CutCube, ShareIsThatOfSmallCubes) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int sample = 0; sample < 100; ++sample) {
    const double x = any(random), y = any(random), z = sample % 3 ? any(random) : 0.02 * any(random);
    const double at = 0.5 * any(random);
    EXPECT_NEAR(share_below({x, y, z}, at), counted({x, y, z}, at), 0.004) << x << " " << y << " " << z << " " << at;
    EXPECT_NEAR(share_below({x, y, z}, at) + share_below({-x, y, z}, -at), 1, 1e-12);
  }
}

TEST(CutCube, ShareIsExactAcrossSidesEdgesAndCorners) {
  for (const double at : {-0.5, -0.3, 0.0, 0.1, 0.5}) {
    EXPECT_NEAR(share_below({0, -1, 0}, at), 0.5 + at, 1e-15);
    EXPECT_NEAR(share_below({0, 2, 0}, 2 * at), 0.5 + at, 1e-15);
  }
  EXPECT_NEAR(share_below({1, 1, 0}, -0.7), 0.5 * 0.3 * 0.3, 1e-15);
  EXPECT_NEAR(share_below({1, -1, 1}, -1.2), 0.3 * 0.3 * 0.3 / 6, 1e-15);
  EXPECT_EQ(share_below({1, 1, 1}, 1.6), 1);
  EXPECT_EQ(share_below({1, 1, 1}, -1.6), 0);
}

}  // namespace
}  // namespace seiche::solver
