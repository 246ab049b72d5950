#include "solver/tank/mesh/lining.hpp"

#include <gtest/gtest.h>

#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/tank/mesh/meshes.hpp"
#include "tests/unit/solver/tank/shapes/wall_points.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
constexpr double l0 = 0.01;
constexpr int layers = 3;
constexpr double reach = 3.1 * l0;

/// Of each layer the sum of weights against the shell that a volume within a distance of the tank leaves.
template <class Within>
void expect_shells(const MeshTank& tank, const Within& within, double tolerance) {
  const auto points = tank.wall_points(layers, l0, reach);
  const auto sums = test::layer_weights(points, layers);
  for (int k = 0; k < layers; ++k) {
    const double shell = (within((k + 1) * l0) - within(k * l0)) / (l0 * l0 * l0);
    EXPECT_NEAR(sums[k] / shell, 1, tolerance) << k;
  }
  test::expect_at_their_layers<3>(tank, points, l0);
}

TEST(Lining, WeightsOfEachLayerSumToItsVolume) {
  expect_shells(
      MeshTank(test::box({0.1, 0.123, 0.087}), l0),
      [](double o) { return (0.1 + 2 * o) * (0.123 + 2 * o) * (0.087 + 2 * o); }, 1e-5);
  expect_shells(
      MeshTank(test::sphere_mesh(0.06, 100), l0), [](double o) { return 4 * pi / 3 * std::pow(0.06 + o, 3); }, 1e-3);
  expect_shells(
      MeshTank(test::cylinder_mesh(0.06, 0.08, 100), l0),
      [](double o) { return pi * std::pow(0.06 + o, 2) * (0.08 + 2 * o); }, 1e-3);
}

TEST(Lining, WeightsOfASolidAreAllOfIt) {
  SurfaceMesh mesh = test::box({0.15, 0.15, 0.15});
  test::add_box(mesh, "block", {0.05, 0.06, 0.07}, {0.1, 0.11, 0.12});
  const MeshTank tank(mesh, l0);
  double sum = 0;
  for (const auto& point : tank.wall_points(layers, l0, reach))
    if (point.patch == 1) sum += point.weight;
  EXPECT_NEAR(sum, 125, 0.1);
  // Of a plate 1.5 l0 thick the second layer is too thin for points of its own.
  SurfaceMesh thin = test::box({0.1, 0.14, 0.14});
  test::add_box(thin, "plate", {0.05, 0.02, 0.02}, {0.065, 0.12, 0.12});
  sum = 0;
  for (const auto& point : MeshTank(thin, l0).wall_points(layers, l0, reach))
    if (point.patch == 1) {
      sum += point.weight;
      EXPECT_EQ(point.layer, 0);
    }
  EXPECT_NEAR(sum, 150, 0.5);
}

TEST(Lining, PointsAreAboutASpacingApart) {
  for (const SurfaceMesh& mesh : {test::box({0.1, 0.123, 0.087}), test::cylinder_mesh(0.06, 0.08, 100)}) {
    const auto points = MeshTank(mesh, l0).wall_points(layers, l0, reach);
    EXPECT_GT(test::least_gap(points), 0.6 * l0);
    double sum = 0, squares = 0;
    for (const auto& point : points) {
      EXPECT_GT(point.weight, 0.5);
      EXPECT_LT(point.weight, 1.8);
      sum += point.weight;
      squares += point.weight * point.weight;
    }
    const auto count = static_cast<double>(points.size());
    EXPECT_NEAR(sum / count, 1, 0.06);
    EXPECT_LT(std::sqrt(squares / count - sum * sum / (count * count)), 0.16);
  }
}

TEST(Lining, CornersOfABoxAreMitredWithTheLatticesPoints) {
  const MeshTank tank(test::box({0.1, 0.12, 0.08}), l0);
  const auto points = tank.wall_points(layers, l0, reach);
  const auto has = [&](const Vec<3>& r) {
    return std::any_of(points.begin(), points.end(), [&](const auto& point) {
      return (point.position - l0 * r).norm() < 1e-6 * l0 && point.normal.isZero();
    });
  };
  for (const double depth : {0.5, 1.5, 2.5}) {
    EXPECT_TRUE(has({-depth, -depth, -depth}));
    EXPECT_TRUE(has({10 + depth, -depth, 8 + depth}));
  }
  for (int k = 0; k < 10; ++k) EXPECT_TRUE(has({k + 0.5, -0.5, -0.5})) << k;
  for (int k = -1; k < 13; ++k) EXPECT_TRUE(has({-1.5, k + 0.5, 9.5})) << k;
}

TEST(Lining, NormalsAreThoseOfTheCurveAndZeroBehindCorners) {
  const auto points = MeshTank(test::cylinder_mesh(0.06, 0.1, 64), l0).wall_points(layers, l0, reach);
  for (const auto& point : points) {
    const Vec<3>& r = point.position;
    const double radius = std::hypot(r[0], r[2]);
    const bool beside = radius > 0.06 + 1e-4, above = r[1] > 0.1 + 1e-9, below = r[1] < -1e-9;
    EXPECT_TRUE(point.faces.empty());
    if (beside && (above || below)) {
      EXPECT_TRUE(point.normal.isZero());
    } else if (beside) {
      EXPECT_LT((point.normal - Vec<3>(r[0], 0, r[2]) / radius).norm(), 0.02);
    } else if (radius < 0.06 * std::cos(pi / 64)) {
      EXPECT_EQ(point.normal, Vec<3>(0, above ? 1 : -1, 0));
    }
  }
}

TEST(Lining, PointsBesideAnEdgeOfTheSolidHaveItsFaces) {
  SurfaceMesh mesh = test::box({0.2, 0.2, 0.2});
  test::add_box(mesh, "block", {0.05, 0.05, 0.05}, {0.15, 0.15, 0.15});
  int edges = 0, corners = 0;
  for (const auto& point : MeshTank(mesh, l0).wall_points(layers, l0, reach)) {
    if (point.patch == 0) {
      EXPECT_TRUE(point.faces.empty());
      continue;
    }
    // Distances to the block's sides, and how many of them are near.
    int near = 0;
    for (int a = 0; a < 3; ++a) near += std::min(point.position[a] - 0.05, 0.15 - point.position[a]) < 0.7 * reach;
    if (near == 1) continue;
    (near == 2 ? edges : corners) += 1;
    ASSERT_GE(point.faces.size(), static_cast<std::size_t>(near)) << point.position.transpose();
    for (const auto& face : point.faces) {
      EXPECT_NEAR(face.normal.norm(), 1, 1e-12);
      EXPECT_GT(face.behind(point.position), 0.4 * l0);
      EXPECT_NEAR(face.behind({0.1, 0.1, 0.1}), 0.05, 1e-12);
    }
  }
  EXPECT_GT(edges, 100);
  EXPECT_GT(corners, 50);
}

TEST(Lining, IsTheSameWhateverTheThreads) {
  const MeshTank tank(test::cylinder_mesh(0.03, 0.05, 40), l0);
  const auto a = tank.wall_points(layers, l0, reach), b = tank.wall_points(layers, l0, reach);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].position, b[k].position);
}

}  // namespace
}  // namespace seiche::solver
