#include "solver/sensors/wall_load.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

template <class T, int D = T::D>
struct WallLoadOf : ::testing::Test {
  SensedTank<D> tank;
  double wide = D == 3 ? 0.12 : 1;
  double weight = 1000 * 9.81 * 0.2 * 0.1 * wide;     ///< of the water
  double end = 1000 * 9.81 * 0.5 * 0.1 * 0.1 * wide;  ///< force on an end wall

  Load<D> load_on(const SurfaceMesh& wall) const {
    const auto& motion = tank.p.motion;
    return WallLoad<D>(wall, Eigen::Vector3d(motion.pivot_x, motion.pivot_y, 0).template head<D>(), l0)
        .read(tank.s, tank.cells());
  }
  Load<D> load() const { return load_on(tank.shape->surface()); }

  /// Load on one patch alone.
  Load<D> load_on(const char* name) const {
    SurfaceMesh wall = tank.shape->surface();
    std::erase_if(wall.patches, [&](const SurfaceMesh::Patch& patch) { return patch.name != name; });
    return load_on(wall);
  }
};
TYPED_TEST_SUITE(WallLoadOf, test::Dimensions);

TYPED_TEST(WallLoadOf, StillWaterPressesWithItsWeight) {
  const auto load = this->load();
  EXPECT_NEAR(load.force[1], -this->weight, 1e-10 * this->weight);
  EXPECT_NEAR(load.force[0], 0, 1e-10 * this->weight);
  EXPECT_NEAR(load.force[TypeParam::D - 1], TypeParam::D == 3 ? 0 : -this->weight, 1e-10 * this->weight);
}

TYPED_TEST(WallLoadOf, OnEachWallIsThatOfAHydrostaticPressure) {
  EXPECT_NEAR(this->load_on("left").force[0], -this->end, 1e-10 * this->end);
  EXPECT_NEAR(this->load_on("right").force[0], this->end, 1e-10 * this->end);
  EXPECT_NEAR(this->load_on("floor").force[1], -this->weight, 1e-10 * this->weight);
  EXPECT_EQ(this->load_on("roof").force[1], 0) << "the roof is dry";
}

TYPED_TEST(WallLoadOf, MomentOfTheHydrostaticPressureIsExact) {
  // The end walls are pressed at a third of the depth, the floor in its middle.
  const double arm = 0.1 / 3;
  EXPECT_NEAR(this->load_on("left").moment[2], this->end * arm, 1e-10 * this->end);
  EXPECT_NEAR(this->load_on("right").moment[2], -this->end * arm, 1e-10 * this->end);
  EXPECT_NEAR(this->load().moment[2], -this->weight * 0.1, 1e-10 * this->weight);
  this->tank.p.motion.pivot_x = 0.03;
  this->tank.p.motion.pivot_y = 0.25;
  EXPECT_NEAR(this->load().moment[2], -this->weight * 0.07, 1e-10 * this->weight);
  EXPECT_NEAR(this->load_on("right").moment[2], -this->end * (arm - 0.25), 1e-10 * this->end);
}

TYPED_TEST(WallLoadOf, TiltedFieldPressesSideways) {
  constexpr int D = TypeParam::D;
  // p = 3000 + 4000 x Pa: the right wall has 800 Pa more than the left wherever it is wet.
  this->tank.p.fluid.depth = this->tank.p.tank.height;
  this->tank.s = fill_tank<D>(this->tank.p);
  this->tank.each_fluid([](const Vec<D>& r, double& p) { p = 3000 + 4000 * r[0]; });
  const auto load = this->load();
  EXPECT_NEAR(load.force[0], 800 * 0.15 * this->wide, 1e-8);
  EXPECT_NEAR(load.force[1], 0, 1e-8) << "roof and floor alike";
}

// A surface anywhere between two rows of wall particles: the cut square costs a hundredth of (l0/h)^2.
TYPED_TEST(WallLoadOf, ASquareCutByTheSurfaceIsRightToSecondOrder) {
  constexpr int D = TypeParam::D;
  for (int tenths = 1; tenths < 10; ++tenths) {
    const double depth = 0.1 + 0.1 * tenths * l0;
    this->tank = SensedTank<D>();
    this->tank.each_fluid([&](Vec<D>& r, double& p) {
      r[1] *= depth / 0.1;
      p = 9810 * (depth - r[1]);
    });
    const double exact = 9810 * 0.5 * depth * depth * this->wide;
    EXPECT_NEAR(this->load_on("right").force[0], exact, 0.011 * exact * std::pow(l0 / depth, 2)) << tenths;
  }
}

TYPED_TEST(WallLoadOf, WaterThatDoesNotTouchDoesNotPress) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double& p) {
    r[0] = 0.05 + 0.5 * r[0];
    p = 1000;
  });
  EXPECT_EQ(this->load_on("right").force[0], 0);
  EXPECT_EQ(this->load_on("left").force[0], 0);
  EXPECT_LT(this->load().force[1], -900 * 0.1 * this->wide);
}

}  // namespace
}  // namespace seiche::solver
