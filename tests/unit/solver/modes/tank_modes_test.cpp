#include "solver/modes/tank_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/modes/closed_forms.hpp"
#include "solver/tank/shapes/built_in.hpp"

namespace seiche::solver::modes {
namespace {

constexpr double g = 9.81;

void expect_frequencies(const std::vector<TankMode>& modes, const std::vector<double>& expected) {
  ASSERT_EQ(modes.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(modes[k].frequency / expected[k], 1, 1e-4) << k;
}

TEST(TankModes, OfAPrismWithARectangleAreTheBoxs) {
  const auto modes = tank_modes(prism({{0, 0}, {0.5, 0}, {0.5, 0.3}, {0, 0.3}}, 0.37), 0.2, g, 6);
  expect_frequencies(modes, box_frequencies({0.5, 0.37}, 0.2, g, 6));
  EXPECT_EQ(modes[0].wave, "across");
  EXPECT_EQ(modes[1].wave, "1 half wave along z");
  EXPECT_EQ(modes[0].from, 0);
  EXPECT_EQ(modes[0].to, 0.5);
}

TEST(TankModes, OfAnUprightCylinderAreTheClosedForms) {
  const auto modes = tank_modes(cylinder(0.25, 0.4, Axis::y, Head::flat), 0.25, g, 5);
  expect_frequencies(modes, upright_cylinder_frequencies(0.25, 0.25, g, 5));
  EXPECT_EQ(modes[0].wave, "1 wave round the axis");
  EXPECT_EQ(modes[1].wave, "2 waves round the axis");
  EXPECT_EQ(modes[2].wave, "the same all round");
}

TEST(TankModes, OfASphere) {
  // Reference eigenfrequencies.
  EXPECT_NEAR(tank_modes(sphere(0.25), 0.25, g, 1)[0].frequency / 7.82436, 1, 1e-4);
}

TEST(TankModes, OfALyingCylinder) {
  // Reference eigenfrequencies, L/R = 4: along it omega^2 R/g = 0.42570; across it 1.35573.
  for (const Axis axis : {Axis::x, Axis::z}) {
    const auto tank = cylinder(0.25, 1, axis, Head::flat);
    const auto modes = tank_modes(tank, 0.25, g, 8);
    EXPECT_NEAR(modes[0].frequency / std::sqrt(0.42570 * g / 0.25), 1, 1e-4);
    EXPECT_EQ(modes[0].wave, axis == Axis::x ? "1 half wave along x" : "1 half wave along z");
    bool found = false;
    for (const TankMode& mode : modes)
      found |= mode.wave == "across" && std::abs(mode.frequency / std::sqrt(1.35573 * g / 0.25) - 1) < 1e-4;
    EXPECT_TRUE(found);
  }
}

TEST(TankModes, OfALyingTankWithRoundEndsAreNotTold) {
  EXPECT_TRUE(tank_modes(cylinder(0.25, 1, Axis::x, Head::elliptical), 0.25, g, 2).empty());
}

TEST(TankModes, OfAnUprightTankWithRoundEndsAreNearlyThoseOfAFlatOneOfItsVolume) {
  // High above the head, its form doesn't matter: exp(-2 k h).
  const auto round = tank_modes(cylinder(0.25, 1, Axis::y, Head::elliptical), 0.875, g, 1);
  EXPECT_NEAR(round[0].frequency / upright_cylinder_frequencies(0.25, 0.8, g, 1)[0], 1, 1e-4);
}

TEST(TankModes, OfAMembraneTank) {
  // The reference's chamfered section: 0.6 x 0.4 m, chamfers of 0.1 m at 45 degrees.
  const auto tank = membrane(0.6, 0.4, {0.1, 0.1}, {0, 0}, 0.4);
  EXPECT_NEAR(tank_modes(tank, 0.2, g, 2)[0].frequency / 6.29400, 1, 1e-4);
  EXPECT_NEAR(tank_modes(tank.section(), 0.2, g, 2)[0].frequency / 6.29400, 1, 1e-4);
}

}  // namespace
}  // namespace seiche::solver::modes
