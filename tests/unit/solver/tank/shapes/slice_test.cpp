#include "solver/tank/shapes/slice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/errors.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

using Names = std::vector<std::string>;

/// Inside the section is inside the tank, at random points of the plane; and areas to compare.
template <class Tank>
void expect_section(const Tank& tank, const SectionPlane& plane, double tolerance) {
  const Section section = slice(tank, plane);
  const Bounds<3> bounds = tank.bounds();
  const int normal = static_cast<int>(plane.axis), across = 2 - normal;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  for (int sample = 0; sample < 300; ++sample) {
    Vec<3> r;
    r[normal] = plane.at;
    for (const int axis : {across, 1}) r[axis] = bounds.low[axis] + share(random) * bounds.size()[axis];
    const double distance = tank.nearest(r).distance, flat = section.nearest({r[across], r[1]}).distance;
    // In the plane the wall is at least as far as in space.
    EXPECT_GE(std::abs(flat), std::abs(distance) - tolerance) << r.transpose();
    if (std::abs(distance) > tolerance) {
      EXPECT_EQ(flat < 0, distance < 0) << r.transpose();
    }
    // The section's wall is the tank's.
    const Vec<2> foot = section.nearest({r[across], r[1]}).foot;
    r[across] = foot[0], r[1] = foot[1];
    EXPECT_LT(std::abs(tank.nearest(r).distance), tolerance);
  }
}

TEST(Slice, IsTheTankInItsPlane) {
  const std::vector<Vec<2>> step{{0, 0}, {0.12, 0}, {0.12, 0.06}, {0.2, 0.06}, {0.2, 0.15}, {0, 0.15}};
  for (const double at : {0.05, 0.15}) expect_section(prism(step, 0.2), {Axis::x, at}, 1e-12);
  expect_section(prism(step, 0.2), {Axis::z, 0.1}, 1e-12);
  const Revolved cone = revolve({{0, 0.02}, {0.06, 0.08}, {0.12, 0.05}, {0.12, 0.09}, {0.2, 0}});
  const Revolved ring = revolve({{0, 0.05}, {0, 0.12}, {0.1, 0.12}, {0.1, 0.05}, {0, 0.05}});
  for (const Axis plane : {Axis::x, Axis::z}) {
    for (const double at : {0.0, -0.03, 0.07}) {
      expect_section(cone, {plane, at}, 1e-6);
      expect_section(ring, {plane, at}, 1e-6);
      for (const Axis axis : {Axis::x, Axis::y, Axis::z})
        expect_section(cylinder(0.08, 0.1, axis, Head::elliptical), {plane, at}, 1e-6);
    }
    expect_section(sphere(0.1), {plane, 0.06}, 1e-6);
  }
}

TEST(Slice, ThroughAnAxisIsExact) {
  const Section circle = slice(sphere(0.1), {Axis::x, 0});
  EXPECT_NEAR(circle.nearest({0.03, 0.14}).distance, -0.05, 1e-15);
  EXPECT_EQ(circle.wall().loops().at(0).size(), 2u);
  EXPECT_EQ(circle.patches(), Names{"shell"});
  EXPECT_EQ(circle.bounds().low[1], 0);
}

TEST(Slice, HasThePatchesThatItMeets) {
  EXPECT_EQ(slice(membrane(1, 1, {0.2, 0.2}, {0.3, 0.3}, 2), {Axis::z, 0}).patches().size(), 8u);
  EXPECT_EQ(slice(membrane(1, 1, {0.2, 0.2}, {0.3, 0.3}, 2), {Axis::x, 0}).patches(),
            (Names{"floor", "roof", "near", "far"}));
  EXPECT_EQ(slice(cylinder(0.3, 0.8, Axis::x, Head::flat), {Axis::x, 0.1}).patches(), Names{"shell"});
  EXPECT_EQ(slice(cylinder(0.3, 0.8, Axis::x, Head::flat), {Axis::z, 0.1}).patches(),
            (Names{"shell", "left_head", "right_head"}));
}

TEST(Slice, LiesAcrossTheAxisAsCircles) {
  const Section ring = slice(cylinder(0.3, 0.8, Axis::z, Head::hemispherical), {Axis::z, 0.5});
  const double radius = std::sqrt(0.09 - 0.01);
  EXPECT_NEAR(ring.area(), std::numbers::pi * radius * radius, 1e-12);
  EXPECT_LT((ring.bounds().low - Vec<2>(-radius, 0.3 - radius)).norm(), 1e-12);
}

TEST(Slice, RefusesAPlaneThatMissesTheTank) {
  try {
    slice(sphere(0.1), {Axis::x, 0.2});
    ADD_FAILURE();
  } catch (const BadParameters& error) {
    EXPECT_TRUE(test::tells(error.what(), {"x = 0.2 m", "-0.1", "0.1 m"}));
  }
}

}  // namespace
}  // namespace seiche::solver
