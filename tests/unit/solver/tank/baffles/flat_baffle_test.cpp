#include "solver/tank/baffles/flat_baffle.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "solver/errors.hpp"
#include "solver/tank/level.hpp"

namespace seiche::solver {
namespace {

/// In the plane y = 1, from x = 0 to 4 and z = 0 to 2.
FlatBaffle shelf(double thickness) { return rectangle({{0, 1, 0}, {4, 1, 0}, {4, 1, 2}}, {}, thickness); }

void expect_nearest(const FlatBaffle& baffle, const Vec<3>& at, double distance, const Vec<3>& normal) {
  const Nearest<3> found = baffle.nearest(at);
  EXPECT_NEAR(found.distance, distance, 1e-12) << at.transpose();
  EXPECT_LT((found.normal - normal).norm(), 1e-12) << at.transpose() << ": " << found.normal.transpose();
  EXPECT_NEAR((found.foot - at).norm(), std::abs(distance), 1e-12) << at.transpose();
}

TEST(FlatBaffle, DistancesToAThickRectangle) {
  const FlatBaffle thick = shelf(0.2);
  expect_nearest(thick, {1, 1.5, 1}, 0.4, {0, 1, 0});
  expect_nearest(thick, {1, 0.7, 1}, 0.2, {0, -1, 0});
  expect_nearest(thick, {1, 1.06, 1}, -0.04, {0, 1, 0});
  expect_nearest(thick, {3.97, 1, 1}, -0.03, {1, 0, 0});
  expect_nearest(thick, {5, 1.05, 1}, 1, {1, 0, 0});
  EXPECT_NEAR(thick.nearest({5, 1.6, 1}).distance, std::hypot(1, 0.5), 1e-12);
  EXPECT_NEAR(thick.nearest({5, 1.6, 3}).distance, std::sqrt(1 + 1 + 0.25), 1e-12);
}

TEST(FlatBaffle, DistancesToADiscWithAHoleAndToARing) {
  const FlatBaffle plate = disc({0, 1, 0}, {0, 2, 0}, 2, {{1, 1, 0, 0.5}}, 0);
  EXPECT_NEAR(plate.nearest({-1, 3, 0}).distance, 2, 1e-12);
  EXPECT_NEAR(plate.nearest({1, 1.4, 0.2}).distance, std::hypot(0.4, 0.3), 1e-12) << "above the hole";
  EXPECT_NEAR(plate.nearest({0, 1.4, 2.3}).distance, 0.5, 1e-12);
  const FlatBaffle ring = disc({0, 0, 0}, {0, 1, 0}, 2, {{0, 0, 0, 1}}, 0.2);
  expect_nearest(ring, {1.05, 0, 0}, -0.05, {-1, 0, 0});
  expect_nearest(ring, {0, 0.05, 0.4}, 0.6, {0, 0, -1});
  expect_nearest(ring, {0, 0.5, 1.5}, 0.4, {0, 1, 0});
}

TEST(FlatBaffle, ASectionCutsItIntoLines) {
  const FlatBaffle ring = disc({0, 0.5, 0}, {0, 1, 0}, 2, {{0, 0.5, 0, 1}}, 0.2);
  const auto through_axis = slice(ring, {Axis::z, 0});
  ASSERT_EQ(through_axis.size(), 2u);
  for (const auto& line : through_axis) {
    EXPECT_NEAR((line.points[1] - line.points[0]).norm(), 1, 1e-12);
    EXPECT_NEAR(line.points[0][1], 0.5, 1e-12);
    EXPECT_NEAR(line.thickness, 0.2, 1e-12);
  }
  EXPECT_NEAR(std::abs(through_axis[0].points[0][0] + through_axis[1].points[1][0]), 0, 1e-12);
  const auto beside = slice(ring, {Axis::x, 1.2});
  ASSERT_EQ(beside.size(), 1u) << "past the opening";
  EXPECT_NEAR((beside[0].points[1] - beside[0].points[0]).norm(), 3.2, 1e-12);
  EXPECT_TRUE(slice(ring, {Axis::z, 2.5}).empty());
  // A plate at 45 degrees is thicker in the section by the root of 2.
  const FlatBaffle slanted = rectangle({{0, 0, -1}, {1, 0, 0}, {1, 1, 0}}, {}, 0.1);
  const auto cut = slice(slanted, {Axis::z, -0.5});
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_NEAR(cut[0].thickness, 0.1 * std::sqrt(2), 1e-12);
  EXPECT_NEAR(cut[0].points[0][0], 0.5, 1e-12);
  EXPECT_NEAR((cut[0].points[1] - cut[0].points[0]).norm(), 1, 1e-12);
  const FlatBaffle across = disc({0, 0, 1}, {0, 0, 1}, 1, {}, 0);
  EXPECT_TRUE(slice(across, {Axis::z, 0}).empty());
  EXPECT_THROW(slice(across, {Axis::z, 1}), BadParameters);
}

TEST(FlatBaffle, HolesAreCutOutOfASection) {
  const FlatBaffle baffle = rectangle({{0, 0, -1}, {0, 3, -1}, {0, 3, 1}}, {{0, 1, 0, 0.5}, {0, 2.5, 0.5, 0.25}}, 0);
  const auto lines = slice(baffle, {Axis::z, 0});
  ASSERT_EQ(lines.size(), 2u);
  double length = 0;
  for (const auto& line : lines) length += (line.points[1] - line.points[0]).norm();
  EXPECT_NEAR(length, 2, 1e-12);
}

void expect_wrong(const std::function<void()>& make, const std::vector<std::string>& words) {
  try {
    make();
    ADD_FAILURE() << "accepted; expected " << words[0];
  } catch (const BadParameters& error) {
    for (const auto& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << word << " in: " << error.what();
  }
}

TEST(FlatBaffle, WhatIsNoneIsRefused) {
  const auto with = [](const std::vector<std::array<double, 4>>& holes) {
    return [holes] { rectangle({{0, 1, 0}, {4, 1, 0}, {4, 1, 2}}, holes, 0); };
  };
  expect_wrong(with({{3.9, 1, 1, 0.2}}), {"hole at (3.9, 1, 1) m", "0.1 m beyond"});
  expect_wrong(with({{2, 1.1, 1, 0.2}}), {"(2, 1.1, 1) m", "0.1 m off", "plane"});
  expect_wrong(with({{2, 1, 1, 0.2}, {2.3, 1, 1, 0.2}}), {"(2, 1, 1) m", "(2.3, 1, 1) m", "overlap"});
  expect_wrong([] { rectangle({{0, 1, 0}, {4, 1, 0}}, {}, 0); }, {"2 corners"});
  expect_wrong([] { rectangle({{0, 1, 0}, {4, 1, 0}, {5, 1, 2}}, {}, 0); }, {"degrees"});
  expect_wrong([] { rectangle({{0, 1, 0}, {4, 1, 0}, {4, 1, 2}, {0, 1, 3}}, {}, 0); }, {"fourth", "(0, 1, 2) m"});
  expect_wrong([] { disc({0, 1, 0}, {0, 0, 0}, 1, {}, 0); }, {"(0, 1, 0) m", "normal"});
}

// Corners of the hole's rim at one height but for rounding left slivers whose neighbours then covered others.
TEST(FlatBaffle, ABulkheadWithAHoleHasTwoSidesOfOneArea) {
  Parameters p;
  p.tank.width = 0.2;
  p.particles.spacing = 0.01;
  p.tank.baffles = {{.corners = {{0.3, 0, 0}, {0.3, 0, 0.2}, {0.3, 0.4, 0.2}}, .holes = {{0.3, 0.2, 0.1, 0.05}}}};
  const SurfaceMesh wall = wall_surface(p);
  EXPECT_NEAR(volume_of(wall), 0.6 * 0.4 * 0.2, 1e-12);
  const double box = 2 * (0.6 * 0.4 + 0.6 * 0.2 + 0.4 * 0.2);
  EXPECT_NEAR(area_of(wall), box + 2 * (0.4 * 0.2 - std::numbers::pi * 0.05 * 0.05), 1e-9);
}

// A hole's rim that crosses the tank's wall leaves no gap there, wherever its points begin.
TEST(CheckFlatBaffles, ARimThatCrossesTheWallIsNoGap) {
  Parameters p;
  p.tank.width = 0.2;
  p.particles.spacing = 0.005;
  p.tank.rings = {{.centre = {0, 0.2, 0}, .inner = 0.1}};
  EXPECT_NO_THROW(check_shape(p));
}

}  // namespace
}  // namespace seiche::solver
