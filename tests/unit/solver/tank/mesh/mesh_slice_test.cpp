#include "solver/tank/mesh/mesh_slice.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/tank/mesh/meshes.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
constexpr double l0 = 0.01;

TEST(MeshSlice, OfABoxIsARectangle) {
  const MeshTank tank(test::box({0.3, 0.2, 0.1}), l0);
  for (const double at : {0.03, 0.05}) {
    const Section flat = slice(tank, {Axis::z, at});
    ASSERT_EQ(flat.wall().loops().size(), 1U);
    EXPECT_EQ(flat.wall().loops()[0].size(), 4U);
    EXPECT_NEAR(flat.area(), 0.06, 1e-12);
    EXPECT_NEAR(flat.bounds().high[0], 0.3, 1e-15);
  }
  const Section across = slice(tank, {Axis::x, 0.1});
  EXPECT_NEAR(across.area(), 0.02, 1e-12);
  EXPECT_NEAR(across.bounds().high[0], 0.1, 1e-15);
  EXPECT_THROW(slice(tank, {Axis::x, 0.31}), BadParameters);
  EXPECT_THROW(slice(tank, {Axis::z, 0}), BadParameters);
}

TEST(MeshSlice, HasHolesAndTheirPatches) {
  SurfaceMesh mesh = test::box({0.3, 0.2, 0.1});
  test::add_box(mesh, "block", {0.1, 0.05, 0.02}, {0.2, 0.1, 0.06});
  const MeshTank tank(mesh, l0);
  const Section through = slice(tank, {Axis::z, 0.04});
  EXPECT_EQ(through.wall().loops().size(), 2U);
  EXPECT_NEAR(through.area(), 0.06 - 0.005, 1e-12);
  EXPECT_EQ(through.patches(), (std::vector<std::string>{"wall", "block"}));
  EXPECT_EQ(through.patches()[through.nearest({0.15, 0.04}).patch], "block");
  EXPECT_GT(through.nearest({0.15, 0.07}).distance, 0);
  EXPECT_EQ(slice(tank, {Axis::z, 0.08}).patches(), (std::vector<std::string>{"wall"}));
  // In the block's own face: as just before it.
  EXPECT_NEAR(slice(tank, {Axis::z, 0.02}).area(), 0.06, 1e-12);
  EXPECT_NEAR(slice(tank, {Axis::z, 0.06}).area(), 0.055, 1e-12);
}

TEST(MeshSlice, ThroughTheAxisOfABodyIsItsProfile) {
  const MeshTank can(test::cylinder_mesh(0.1, 0.2, 64), l0);
  for (const Axis axis : {Axis::x, Axis::z}) {
    const Section section = slice(can, {axis, 0});
    EXPECT_EQ(section.wall().loops()[0].size(), 4U);
    EXPECT_NEAR(section.area(), 0.04, 1e-9);
  }
  const MeshTank ball(test::sphere_mesh(0.1, 64), l0);
  for (const double at : {0.0, 0.05, 0.08}) {
    const double exact = pi * (0.01 - at * at);
    EXPECT_NEAR(slice(ball, {Axis::x, at}).area(), exact, 1e-4);
    EXPECT_NEAR(slice(ball, {Axis::z, at}).area(), exact, 1e-4);
  }
}

TEST(MeshSlice, IsTheSectionWhereverThePlaneIs) {
  SurfaceMesh mesh = test::turned({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0.05, 0.1}, {0.05, 0.2}, {0, 0.2}}, 30);
  test::turn_some(mesh);
  const MeshTank tank(mesh, l0);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-0.099, 0.099), height(0, 0.2);
  for (int sample = 0; sample < 40; ++sample) {
    const Axis axis = sample % 2 ? Axis::x : Axis::z;
    const double at = place(random);
    const Section section = slice(tank, {axis, at});
    for (int k = 0; k < 40; ++k) {
      const Vec<2> r(1.2 * place(random), height(random));
      Vec<3> in_tank(0, r[1], 0);
      in_tank[static_cast<int>(axis)] = at;
      in_tank[2 - static_cast<int>(axis)] = r[0];
      if (const double distance = section.nearest(r).distance; std::abs(distance) > 1e-6) {
        EXPECT_EQ(distance < 0, tank.nearest(in_tank).distance < 0);
      }
    }
  }
}

}  // namespace
}  // namespace seiche::solver
