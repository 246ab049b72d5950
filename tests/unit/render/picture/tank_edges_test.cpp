#include "render/picture/tank_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/render/synthetic.hpp"

namespace seiche::render {
namespace {

using Eigen::Vector3d;
const Vector3d to_camera = Vector3d::Ones().normalized();

double length(const std::vector<std::array<Vector3d, 2>>& edges) {
  double sum = 0;
  for (const auto& [from, to] : edges) sum += (to - from).norm();
  return sum;
}

TEST(TankEdges, OfABoxAreItsOwnAlsoWithoutALid) {
  for (const bool closed : {true, false}) {
    const RunInfo run = test::run_info({.length = 0.4, .height = 0.3, .width = 0.2, .closed = closed});
    EXPECT_EQ(tank_edges(run.tank, to_camera).size(), 12u);
    EXPECT_NEAR(length(tank_edges(run.tank, to_camera)), 4 * (0.4 + 0.3 + 0.2), 1e-9);
  }
}

// A sphere of quadrilaterals whose corners are each their own.
TEST(TankEdges, OfASphereAreItsOutline) {
  constexpr int rings = 60, around = 120;
  SurfaceMesh ball{{}, {{"shell", {}}}};
  const auto point = [](int i, int j) {
    const double polar = std::numbers::pi * i / rings, angle = 2 * std::numbers::pi * j / around;
    return std::array{std::sin(polar) * std::cos(angle), std::cos(polar), -std::sin(polar) * std::sin(angle)};
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const int first = static_cast<int>(ball.points.size());
      ball.points.insert(ball.points.end(), {point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
      ball.patches[0].faces.push_back({first, first + 1, first + 2, first + 3});
    }
  const auto edges = tank_edges(ball, to_camera);
  double seen = 0;
  for (const auto& [from, to] : edges) {
    EXPECT_LT(std::abs(from.dot(to_camera)), 0.06);
    // Along the outline, as the camera sees it.
    seen += (to - from - (to - from).dot(to_camera) * to_camera).norm();
  }
  EXPECT_GT(seen, 2 * std::numbers::pi * 0.99);
  EXPECT_LT(seen, 2 * std::numbers::pi * 1.5);
}

// Both sides of two squares beside each other.
TEST(TankEdges, OfAPlateAreItsRim) {
  SurfaceMesh plate{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{"baffle", {}}}};
  plate.patches[0].faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 1, 0}, {4, 5, 2, 1}};
  EXPECT_NEAR(length(tank_edges(plate, to_camera)), 6, 1e-12);
}

}  // namespace
}  // namespace seiche::render
