#include "solver/sensors/budget.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::SensedTank;

template <class T, int D = T::D>
struct BudgetOf : ::testing::Test {
  SensedTank<D> tank;
  double mass = 1000 * 0.2 * 0.1 * (D == 3 ? 0.12 : 1);

  Budget<D> read(const RigidState& pose = {}) const { return budget(tank.s, tank.p, 0.5 * tank.p.fluid.depth, pose); }
};
TYPED_TEST_SUITE(BudgetOf, test::Dimensions);

TYPED_TEST(BudgetOf, OfStillWaterIsZeroAboutItsMiddle) {
  constexpr int D = TypeParam::D;
  const auto all = this->read();
  EXPECT_EQ(all.kinetic, 0);
  EXPECT_NEAR(all.potential, 0, 1e-10);
  EXPECT_LT((all.centre - this->tank.at(0.1, 0.05)).norm(), 1e-12) << D;
}

TYPED_TEST(BudgetOf, MovingWater) {
  constexpr int D = TypeParam::D;
  std::fill(this->tank.s.velocity.begin(), this->tank.s.velocity.end(), 0.5 * Vec<D>::Unit(0) + 0.2 * Vec<D>::Unit(1));
  this->tank.each_fluid([](Vec<D>& r, double&) { r += 0.02 * Vec<D>::Unit(0) + 0.01 * Vec<D>::Unit(1); });
  const auto all = this->read();
  EXPECT_NEAR(all.kinetic, 0.5 * this->mass * 0.29, 1e-10) << "walls don't count";
  EXPECT_NEAR(all.potential, this->mass * 9.81 * 0.01, 1e-9);
  EXPECT_LT((all.centre - this->tank.at(0.12, 0.06)).norm(), 1e-12);
}

// The middle of the water, (0.1, 0.05), about the pivot (0.1, 0.2): rolled by 60 degrees it rises by half its distance.
TYPED_TEST(BudgetOf, PotentialEnergyIsByTheHeightInTheLab) {
  RigidState pose;
  pose.displacement = {0.7, 0.03, 0};
  EXPECT_NEAR(this->read(pose).potential, this->mass * 9.81 * 0.03, 1e-9) << "heaved";
  pose = {};
  pose.orientation = Eigen::AngleAxisd(std::acos(0.5), Eigen::Vector3d::UnitZ());
  pose.pivot = {0.1, 0.2, 0};
  EXPECT_NEAR(this->read(pose).potential, this->mass * 9.81 * 0.075, 1e-9) << "rolled";
  pose.pivot = {0, 0.2, 0};
  EXPECT_NEAR(this->read(pose).potential, this->mass * 9.81 * (0.075 + 0.1 * std::sqrt(0.75)), 1e-9) << "off its pivot";
}

TYPED_TEST(BudgetOf, NoWaterHasNothing) {
  constexpr int D = TypeParam::D;
  this->tank.s = {};
  const auto all = this->read();
  EXPECT_EQ(all.potential, 0);
  EXPECT_EQ(all.centre, (Vec<D>(Vec<D>::Zero())));
}

}  // namespace
}  // namespace seiche::solver
