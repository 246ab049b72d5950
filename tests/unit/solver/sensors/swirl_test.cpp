#include "solver/sensors/swirl.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver::test {
namespace {

double swirl(SensedTank<3>& tank, const Vec<3>& velocity, const Vec<3>& omega) {
  const Vec<3> middle(0.1, 0.05, 0.06);
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    tank.s.velocity[i] = velocity + omega.cross(Vec<3>(tank.s.position[i] - middle));
  const FluidCells<3> cells = tank.cells();
  Scalars values;
  SwirlSensor<3>(tank.site()).read({tank.s, cells, tank.profile(), {}}, values);
  EXPECT_EQ(values.size(), 1u);
  return values.front();
}

// Of n cells of size l0 in a row the mean of x^2 is (n^2 - 1) l0^2/12.
TEST(Swirl, IsTheAngularMomentumOfARigidRotation) {
  SensedTank<3> tank;
  const double l0 = tank.p.particles.spacing;
  const double mass = tank.p.fluid.density * 0.2 * 0.1 * 0.12;
  const auto squares = [&](double length) { return (std::pow(length / l0, 2) - 1) * l0 * l0 / 12; };
  EXPECT_NEAR(swirl(tank, {0, 0, 0}, {0, 3, 0}) / (3 * mass * (squares(0.2) + squares(0.12))), 1, 1e-12);
}

TEST(Swirl, IsPositiveFromXTowardsMinusZ) {
  SensedTank<3> tank;
  EXPECT_GT(swirl(tank, {0, 0, 0}, Vec<3>(1, 0, 0).cross(Vec<3>(0, 0, -1))), 0);
}

TEST(Swirl, IsNoneOfWhatMovesAsOne) {
  SensedTank<3> tank;
  EXPECT_NEAR(swirl(tank, {0.3, 0.2, -0.5}, {0, 0, 0}), 0, 1e-12);
}

TEST(Swirl, IsNoneAboutALevelAxis) {
  SensedTank<3> tank;
  EXPECT_NEAR(swirl(tank, {0, 0, 0}, {2, 0, 0}), 0, 1e-12);
}

TEST(Swirl, IsOf3DRunsWhoseVolumeIsAskedFor) {
  Parameters p = small_tank<3>();
  EXPECT_EQ(SwirlSensor<3>::columns(p).front().name, "swirl");
  EXPECT_GT(SwirlSensor<3>::columns(p).front().scale, 0);
  EXPECT_TRUE(SwirlSensor<2>::columns(small_tank<2>()).empty());
  p.sensors.volume = false;
  EXPECT_TRUE(SwirlSensor<3>::columns(p).empty());
}

}  // namespace
}  // namespace seiche::solver::test
