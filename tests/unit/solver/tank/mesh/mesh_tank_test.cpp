#include "solver/tank/mesh/mesh_tank.hpp"

#include <gtest/gtest.h>

#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/tank/mesh/meshes.hpp"
#include "tests/unit/solver/tank/shapes/bodies_checks.hpp"

namespace seiche::solver {
namespace {

constexpr double l0 = 0.01;

/// A box with a box in it and a step, all faces at random.
SurfaceMesh room_with_block() {
  SurfaceMesh mesh = test::box({0.3, 0.3, 0.3});
  test::add_box(mesh, "block", {0.1, 0.12, 0.08}, {0.18, 0.2, 0.2});
  return mesh;
}

std::vector<SurfaceMesh> meshes() {
  std::vector<SurfaceMesh> all{test::box({0.2, 0.15, 0.1}), test::sphere_mesh(0.1, 48),
                               test::cylinder_mesh(0.1, 0.2, 48), room_with_block(),
                               test::turned({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0.05, 0.1}, {0.05, 0.2}, {0, 0.2}}, 30)};
  for (SurfaceMesh& mesh : all) test::turn_some(mesh);
  return all;
}

TEST(MeshTank, DistancesAreExactWhateverWayFacesAreRound) {
  for (const SurfaceMesh& mesh : meshes()) test::expect_exact_distances(MeshTank(mesh, l0), 150, 0.25);
}

TEST(MeshTank, SurfaceIsClosedFacesOutwardsAndHoldsTheVolume) {
  for (const SurfaceMesh& mesh : meshes()) {
    const MeshTank tank(mesh, l0);
    const test::Enclosed inside = test::enclosed(tank.surface());
    EXPECT_LT(inside.normal.norm(), 1e-12);
    EXPECT_NEAR(inside.volume, tank.volume(), 1e-12);
    EXPECT_NEAR(inside.area, tank.area(), 1e-12);
    EXPECT_GT(tank.volume(), 0);
  }
  EXPECT_NEAR(MeshTank(room_with_block(), l0).volume(), 0.027 - 0.08 * 0.08 * 0.12, 1e-12);
}

TEST(MeshTank, SignsAreThoseOfTheBody) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-0.15, 0.35);
  const MeshTank block(room_with_block(), l0), ball(test::sphere_mesh(0.1, 200), l0),
      can(test::cylinder_mesh(0.1, 0.2, 200), l0);
  for (int sample = 0; sample < 2000; ++sample) {
    const double x = place(random), y = place(random), z = place(random);
    const auto within = [](double v, double low, double high) { return v > low && v < high; };
    const bool in = within(x, 0, 0.3) && within(y, 0, 0.3) && within(z, 0, 0.3) &&
                    !(within(x, 0.1, 0.18) && within(y, 0.12, 0.2) && within(z, 0.08, 0.2));
    EXPECT_EQ(block.nearest({x, y, z}).distance < 0, in);
    const double from_middle = Vec<3>(x, y, z).norm(), from_axis = std::hypot(x, z);
    EXPECT_NEAR(ball.nearest({x, y, z}).distance, from_middle - 0.1, 2e-4 * 0.1 + 1e-5);
    if (std::abs(from_axis - 0.1) > 2e-5 && y > 1e-9) {
      EXPECT_EQ(can.nearest({x, y, z}).distance < 0, from_axis < 0.1 && within(y, 0, 0.2));
    }
  }
}

TEST(MeshTank, IsNearlyTheBuiltInBodyWhoseSurfaceItHas) {
  for (const Revolved& body : {sphere(0.1), cylinder(0.08, 0.1, Axis::y, Head::flat)}) {
    const MeshTank tank(body.surface(), l0);
    EXPECT_TRUE(tank.faults().turned == 0 || tank.faults().turned == tank.wall().mesh().count());
    EXPECT_EQ(tank.faults().holes.open_sides, 0);
    EXPECT_NEAR(tank.volume() / body.volume(), 1, 1.1e-4);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-0.2, 1.2);
    for (int sample = 0; sample < 100; ++sample) {
      Vec<3> r = body.bounds().low;
      for (int a = 0; a < 3; ++a) r[a] += share(random) * body.bounds().size()[a];
      EXPECT_NEAR(tank.nearest(r).distance, body.nearest(r).distance, 1e-5);
    }
  }
}

TEST(MeshTank, HasItsPatches) {
  const MeshTank tank(room_with_block(), l0);
  EXPECT_EQ(tank.patches(), (std::vector<std::string>{"wall", "block"}));
  EXPECT_EQ(tank.nearest({0.09, 0.15, 0.1}).patch, 1);
  EXPECT_EQ(tank.nearest({0.04, 0.15, 0.1}).patch, 0);
  EXPECT_EQ(tank.nearest({0.09, 0.15, 0.1}).normal, Vec<3>(1, 0, 0));
  EXPECT_EQ(tank.surface().patches[1].faces.size(), 12U);
  EXPECT_EQ(tank.description(), "x from 0 to 0.3 m, y from 0 to 0.3 m, z from 0 to 0.3 m");
}

TEST(MeshTank, BehindACornerTheNormalIsOfTheWallThatAPointIsFartherBehind) {
  const MeshTank tank(test::box({0.3, 0.3, 0.3}), l0);
  EXPECT_EQ(tank.nearest({-0.02, -0.01, 0.1}).normal, Vec<3>(-1, 0, 0));
  EXPECT_EQ(tank.nearest({-0.02, -0.01, -0.03}).normal, Vec<3>(0, 0, -1));
  EXPECT_NEAR(tank.nearest({-0.02, -0.01, -0.03}).distance, std::sqrt(14) * 0.01, 1e-15);
}

}  // namespace
}  // namespace seiche::solver
