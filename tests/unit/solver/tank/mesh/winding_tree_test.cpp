#include "solver/tank/mesh/winding_tree.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/tank/mesh/meshes.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;

TEST(WindingTree, SolidAngleOfAnOctantIsAnEighthOfASphere) {
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), 4 * pi / 8, 1e-14);
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 0, 3}, {0, 2, 0}), -4 * pi / 8, 1e-14);
}

TEST(WindingTree, IsOneInsideAndNoneOutside) {
  LeftOut left_out;
  for (const SurfaceMesh& surface : {test::sphere_mesh(0.5, 64), test::cylinder_mesh(0.5, 0.5, 90)}) {
    const Triangles mesh = triangles_of(surface, left_out);
    const WindingTree tree(mesh);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-0.8, 0.8);
    for (int sample = 0; sample < 1000; ++sample) {
      const double x = place(random), y = place(random), z = place(random);
      double exact = 0;
      for (int t = 0; t < mesh.count(); ++t) {
        const Vec<3> r(x, y, z);
        exact += solid_angle(mesh.corner(t, 0) - r, mesh.corner(t, 1) - r, mesh.corner(t, 2) - r) / (4 * pi);
      }
      EXPECT_NEAR(exact, std::round(exact), 1e-9);
      EXPECT_NEAR(tree.number({x, y, z}), exact, 0.05);
    }
  }
}

TEST(WindingTree, IsAHalfInAnOpening) {
  LeftOut left_out;
  SurfaceMesh open = test::box({1, 1, 1});
  open.patches[0].faces.resize(10);  // without z = 1
  const Triangles mesh = triangles_of(open, left_out);
  EXPECT_NEAR(WindingTree(mesh).number({0.5, 0.5, 1}), 0.5, 1e-12);
  EXPECT_NEAR(WindingTree(mesh).number({0.5, 0.5, 0.5}), 5.0 / 6, 1e-12);
}

}  // namespace
}  // namespace seiche::solver
