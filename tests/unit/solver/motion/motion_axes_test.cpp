#include "solver/motion/motion_axes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace seiche {
namespace {

Eigen::Vector3d direction(const TankAxis& axis) { return axis.sign * Eigen::Vector3d::Unit(axis.axis); }

Parameters::Motion ship(TankX x) {
  Parameters::Motion m;
  m.axes = MotionAxes::ship;
  m.tank_x = x;
  return m;
}

TEST(MotionAxes, AreRightHanded) {
  for (const Parameters::Motion& m : {Parameters::Motion{}, ship(TankX::forward), ship(TankX::port)}) {
    const auto [first, second, third] = axes_of(m);
    EXPECT_EQ(direction(first).cross(direction(second)), direction(third));
  }
}

TEST(MotionAxes, OfAShipHaveTheTanksYUpwards) {
  for (const TankX x : {TankX::forward, TankX::port}) EXPECT_EQ(axes_of(ship(x))[2], (TankAxis{1, 1}));
}

TEST(MotionAxes, OfAShipPutTheTanksXWhereTheSceneSays) {
  EXPECT_EQ(axis_of(row(DegreeOfFreedom::surge), ship(TankX::forward)), (TankAxis{0, 1}));
  EXPECT_EQ(axis_of(row(DegreeOfFreedom::sway), ship(TankX::forward)), (TankAxis{2, -1})) << "z is to starboard";
  EXPECT_EQ(axis_of(row(DegreeOfFreedom::sway), ship(TankX::port)), (TankAxis{0, 1}));
  EXPECT_EQ(axis_of(row(DegreeOfFreedom::surge), ship(TankX::port)), (TankAxis{2, 1})) << "z is forward";
}

std::vector<DegreeOfFreedom> plane_of(const Parameters::Motion& m) {
  std::vector<DegreeOfFreedom> all;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (in_plane(row, m)) all.push_back(row.value);
  return all;
}

TEST(MotionAxes, HaveThreeDegreesOfFreedomInThePlaneOfATwoDimensionalRun) {
  using enum DegreeOfFreedom;
  EXPECT_EQ(plane_of({}), (std::vector{surge, heave, roll}));
  EXPECT_EQ(plane_of(ship(TankX::forward)), (std::vector{surge, heave, pitch}));
  EXPECT_EQ(plane_of(ship(TankX::port)), (std::vector{heave, sway, roll}));
}

TEST(MotionAxes, EachHaveARotation) {
  using enum DegreeOfFreedom;
  EXPECT_EQ(rotation_about(0, {}), pitch);
  EXPECT_EQ(rotation_about(1, {}), yaw);
  EXPECT_EQ(rotation_about(2, {}), roll);
  EXPECT_EQ(rotation_about(0, ship(TankX::port)), roll);
  EXPECT_EQ(rotation_about(1, ship(TankX::port)), pitch);
  EXPECT_EQ(rotation_about(2, ship(TankX::port)), yaw);
}

}  // namespace
}  // namespace seiche
