#include "solver/tank/shapes/revolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/tank/shapes/bodies_checks.hpp"
#include "tests/unit/solver/tank/shapes/wall_points.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
constexpr double l0 = 0.01;
constexpr int layers = 3;
constexpr double reach = 3.1 * l0;

TEST(Revolved, OfASphereIsExact) {
  const Revolved tank = sphere(0.1);
  EXPECT_NEAR(tank.volume(), 4 * pi / 3 * 1e-3, 1e-15);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.2, 0.2);
  for (int sample = 0; sample < 200; ++sample) {
    const Vec<3> off(place(random), place(random), place(random));
    const Nearest<3> wall = tank.nearest(Vec<3>(0, 0.1, 0) + off);
    EXPECT_NEAR(wall.distance, off.norm() - 0.1, 1e-14);
    EXPECT_LT((wall.normal - off.normalized()).norm(), 1e-9);
  }
  EXPECT_NEAR(tank.nearest({0, 0.03, 0}).distance, -0.03, 1e-15) << "on the axis";
  EXPECT_NEAR((tank.bounds().low - Vec<3>(-0.1, 0, -0.1)).norm(), 0, 1e-15);
}

/// Bodies about each axis, with corners, heads, a reentrant edge and a hole.
std::vector<Revolved> bodies() {
  return {sphere(0.1),
          cylinder(0.08, 0.1, Axis::y, Head::flat),
          cylinder(0.08, 0.1, Axis::x, Head::elliptical),
          cylinder(0.08, 0.1, Axis::z, Head::torispherical),
          cylinder(0.08, 0.06, Axis::x, Head::hemispherical),
          revolve({{0, 0}, {0.06, 0.08}, {0.12, 0.05}, {0.12, 0.09}, {0.2, 0}}),
          revolve({{0, 0.05}, {0, 0.12}, {0.1, 0.12}, {0.1, 0.05}, {0, 0.05}})};
}

TEST(Revolved, DistancesAreExact) {
  for (const Revolved& tank : bodies()) test::expect_exact_distances(tank, 40, 0.1);
}

TEST(Revolved, SurfaceIsClosedFacesOutwardsAndHoldsTheVolume) {
  for (const Revolved& tank : bodies()) {
    const test::Enclosed inside = test::enclosed(tank.surface());
    EXPECT_LT(inside.normal.norm(), 1e-10);
    EXPECT_NEAR(inside.volume / tank.volume(), 1, 1.1e-4);
  }
}

TEST(Revolved, PointsAreAtTheirLayersAndNotTooNear) {
  int body = 0;
  for (const Revolved& tank : bodies()) {
    const auto points = tank.wall_points(layers, l0, reach);
    test::expect_at_their_layers<3>(tank, points, l0);
    EXPECT_GT(test::least_gap(points), 0.6 * l0) << body++;
  }
}

TEST(Revolved, WeightsOfEachLayerSumToItsArea) {
  const auto check = [](const Revolved& tank, const auto& area) {
    const auto sums = test::layer_weights(tank.wall_points(layers, l0, reach), layers);
    for (int k = 0; k < layers; ++k)
      EXPECT_NEAR(sums[static_cast<std::size_t>(k)] * l0 * l0 / area((k + 0.5) * l0), 1, 1e-6) << k;
  };
  check(sphere(0.1), [](double o) { return 4 * pi * (0.1 + o) * (0.1 + o); });
  check(cylinder(0.08, 0.1, Axis::y, Head::flat),
        [](double o) { return 2 * pi * (0.08 + o) * (0.1 + 2 * o) + 2 * pi * (0.08 + o) * (0.08 + o); });
  check(cylinder(0.08, 0.06, Axis::x, Head::hemispherical),
        [](double o) { return 2 * pi * (0.08 + o) * 0.06 + 4 * pi * (0.08 + o) * (0.08 + o); });
}

/// Share of the sum of (1 - (s/R)^2)^2 over all points within R = 2.6 l0 of r that lies in the solid: the integral.
double solid_share(const Shape<3>& tank, const Vec<3>& r, double range) {
  const double cell = 0.1 * l0;
  const int reach_cells = static_cast<int>(range / cell);
  double sum = 0;
  for (int i = -reach_cells; i <= reach_cells; ++i)
    for (int j = -reach_cells; j <= reach_cells; ++j)
      for (int k = -reach_cells; k <= reach_cells; ++k) {
        const Vec<3> off = cell * Vec<3>(i + 0.5, j + 0.5, k + 0.5);
        const double q = off.squaredNorm() / (range * range);
        if (q < 1 && tank.nearest(r + off).distance > 0) sum += (1 - q) * (1 - q);
      }
  return sum * std::pow(cell / l0, 3);
}

TEST(Revolved, APairSumOverItsPointsIsTheIntegralOverTheSolid) {
  const double range = 2.6 * l0, whole = 32 * pi / 105 * std::pow(2.6, 3);
  for (const Revolved& tank : {sphere(0.1), cylinder(0.08, 0.1, Axis::y, Head::flat)}) {
    const auto points = tank.wall_points(layers, l0, reach);
    for (const Vec<3>& r : {Vec<3>(0.01, 0.005, 0.013), Vec<3>(0, 0.005, 0), Vec<3>(0.05, 0.03, 0.03)}) {
      double sum = 0;
      for (const auto& point : points) {
        const double q = (point.position - r).squaredNorm() / (range * range);
        if (q < 1) sum += point.weight * (1 - q) * (1 - q);
      }
      EXPECT_NEAR(sum / whole, solid_share(tank, r, range) / whole, 0.015) << r.transpose();
    }
  }
}

TEST(Revolved, EachRingPullsNoWay) {
  // The normals of a layer sum to nothing across the axis, so that no ring pushes still liquid sideways.
  for (const Revolved& tank : bodies()) {
    Vec<3> sum = Vec<3>::Zero();
    for (const auto& point : tank.wall_points(layers, l0, reach)) sum += point.weight * point.normal;
    sum[tank.axis()] = 0;
    EXPECT_LT(sum.norm(), 1e-9);
  }
}

TEST(Revolved, FacesOfAConvexEdgeTurnWithTheRing) {
  const Revolved tank = bodies()[5];
  int with_faces = 0;
  for (const auto& point : tank.wall_points(layers, l0, reach))
    for (const auto& face : point.faces) {
      ++with_faces;
      // The edge at (radius 0.05, height 0.12) at the point's angle lies on both faces.
      const Vec<3> out = Vec<3>(point.position[0], 0, point.position[2]).normalized();
      EXPECT_NEAR(face.behind(0.05 * out + Vec<3>(0, 0.12, 0)), 0, 1e-12);
    }
  EXPECT_GT(with_faces, 100);
}

}  // namespace
}  // namespace seiche::solver
