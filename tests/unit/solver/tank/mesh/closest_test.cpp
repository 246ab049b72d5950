#include "solver/tank/mesh/closest.hpp"

#include <gtest/gtest.h>

#include "solver/tank/mesh/creases.hpp"
#include "tests/unit/solver/tank/mesh/meshes.hpp"

namespace seiche::solver {
namespace {

Vec<3> random_point(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> share(-size, size);
  const double x = share(random), y = share(random), z = share(random);
  return {x, y, z};
}

/// By the definition: of a fine grid of points on the triangle.
double sampled_distance(const Triangles& mesh, int t, const Vec<3>& r) {
  constexpr int parts = 200;
  double least = 1e9;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) {
      const Vec<3> at = (i * mesh.corner(t, 0) + j * mesh.corner(t, 1) + (parts - i - j) * mesh.corner(t, 2)) / parts;
      least = std::min(least, (at - r).norm());
    }
  return least;
}

TEST(Closest, FootOnATriangleIsTheNearestOfItsPoints) {
  std::mt19937 random(1);
  for (int sample = 0; sample < 200; ++sample) {
    Triangles mesh;
    for (int k = 0; k < 3; ++k) mesh.points.push_back(random_point(random, 1));
    mesh.add({0, 1, 2}, 0);
    const Vec<3> r = random_point(random, 2);
    const Foot foot = foot_on(mesh, 0, r);
    const double distance = std::sqrt(foot.squared_distance), sampled = sampled_distance(mesh, 0, r);
    EXPECT_NEAR(distance, (r - foot.at).norm(), 1e-14);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GT(distance, sampled - 0.01);
    const Vec<3> normal = mesh.area(0).normalized();
    EXPECT_NEAR(normal.dot(foot.at - mesh.points[0]), 0, 1e-12);
    if (foot.on == Foot::On::face) {
      EXPECT_NEAR(std::abs(normal.dot(r - foot.at)), distance, 1e-12);
    }
    if (foot.on == Foot::On::corner) {
      EXPECT_EQ(foot.at, mesh.points[foot.k]);
    }
    if (foot.on == Foot::On::side) {
      const Vec<3> way = mesh.points[(foot.k + 1) % 3] - mesh.points[foot.k];
      EXPECT_NEAR(way.dot(r - foot.at), 0, 1e-12);
      EXPECT_NEAR(cross(way, foot.at - mesh.points[foot.k]).norm(), 0, 1e-12);
    }
  }
}

TEST(Closest, FindsTheNearestOfAllTriangles) {
  std::mt19937 random(2);
  for (const SurfaceMesh& surface :
       {test::sphere_mesh(0.7, 40), test::cylinder_mesh(0.4, 0.9, 50), test::box({0.3, 0.8, 0.5})}) {
    LeftOut left_out;
    const Triangles mesh = triangles_of(surface, left_out);
    const Closest closest(mesh);
    for (int sample = 0; sample < 300; ++sample) {
      const Vec<3> r = random_point(random, 1.2);
      double least = 1e9;
      for (int t = 0; t < mesh.count(); ++t) least = std::min(least, foot_on(mesh, t, r).squared_distance);
      EXPECT_EQ(closest.foot(r).squared_distance, least);
      EXPECT_EQ(closest.foot(r, std::sqrt(least) * (1 + 1e-12)).squared_distance, least);
    }
  }
}

TEST(Creases, NormalsOfACurvedWallAreThoseOfTheCurve) {
  LeftOut left_out;
  const Triangles sphere = triangles_of(test::sphere_mesh(1, 60), left_out);
  const Creases smooth(sphere);
  const Closest closest(sphere);
  EXPECT_TRUE(smooth.all().empty());
  std::mt19937 random(3);
  for (int sample = 0; sample < 300; ++sample) {
    const Vec<3> r = random_point(random, 1);
    EXPECT_LT((smooth.smooth_normal(closest.foot(r)) - closest.foot(r).at.normalized()).norm(), 0.02);
  }
  const Triangles cylinder = triangles_of(test::cylinder_mesh(1, 1, 60), left_out);
  const Creases rims(cylinder);
  EXPECT_EQ(rims.all().size(), 120U);
  for (const Crease& crease : rims.all()) EXPECT_NEAR(crease.turn, std::numbers::pi / 2, 1e-12);
  const Closest near(cylinder);
  EXPECT_EQ(rims.smooth_normal(near.foot({0.9, -0.1, 0.01})), Vec<3>(0, -1, 0));
  EXPECT_TRUE(rims.is_corner(near.foot({1.1, -0.1, 0.01})));
  EXPECT_FALSE(rims.is_corner(near.foot({1.1, 0.1, 0})));
}

}  // namespace
}  // namespace seiche::solver
