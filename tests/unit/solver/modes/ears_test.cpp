#include "solver/modes/ears.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

using std::numbers::pi;

double area(const Loop& loop) {
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) twice += turn({0, 0}, loop[k].at, loop[(k + 1) % loop.size()].at);
  return 0.5 * twice;
}

/// Expects triangles that turn left, as many as Euler's formula asks for, and of the outline's area in sum.
void expect_filled(const Outline& outline) {
  const Walk walk = joined(outline);
  const auto triangles = ears(walk, outline);
  double expected = area(outline.outer), sum = 0;
  for (const Loop& hole : outline.holes) expected += area(hole);
  for (const auto& triangle : triangles) {
    const auto at = [&](std::size_t k) { return walk.corners[static_cast<std::size_t>(triangle[k])].at; };
    const double twice = turn(at(0), at(1), at(2));
    EXPECT_GT(twice, 0);
    sum += 0.5 * twice;
  }
  EXPECT_NEAR(sum, expected, 1e-12 * expected);
  EXPECT_EQ(triangles.size(), walk.corners.size() + 2 * outline.holes.size() - 2);
}

std::vector<Vec<2>> star(const Vec<2>& centre, double low, double high, int corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(low, high);
  std::vector<Vec<2>> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * pi * k / corners;
    points.push_back(centre + radius(random) * Vec<2>(std::cos(angle), std::sin(angle)));
  }
  return points;
}

double level_of(const Polygons& section, double share) {
  const auto [low, high] = std::minmax_element(section[0].begin(), section[0].end(),
                                               [](const Vec<2>& a, const Vec<2>& b) { return a[1] < b[1]; });
  return (1 - share) * (*low)[1] + share * (*high)[1];
}

std::vector<Vec<2>> turned_round(std::vector<Vec<2>> points) { return {points.rbegin(), points.rend()}; }

TEST(Ears, FillStarsAtAnyLevel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  for (int run = 0; run < 200; ++run) {
    const Polygons section{star({0, 0}, 0.1, 1, 40, random)};
    for (const Outline& body : liquid_below(level_of(section, share(random)), section)) expect_filled(body);
  }
}

TEST(Ears, FillStarsWithHoles) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  for (int run = 0; run < 200; ++run) {
    Polygons section{star({0, 0}, 0.7, 1, 30, random)};
    for (int k = 0; k < 6; ++k)
      section.push_back(turned_round(star(0.45 * Vec<2>(std::cos(k), std::sin(k)), 0.02, 0.2, 9, random)));
    for (const Outline& body : liquid_below(level_of(section, share(random)), section)) expect_filled(body);
  }
}

TEST(Ears, FillRoundPlates) {
  Polygons section = test::box(1, 1);
  for (int k = 1; k < 9; ++k) section.push_back({{0.1 * k, 0.1 + 0.03 * k}, {0.1 * k, 0.6}});
  section.push_back({{0.15, 0.9}, {0.5, 0.8}, {0.7, 0.8}, {0.5, 0.8}});
  for (const double level : {0.3, 0.6, 0.85, 0.95})
    for (const Outline& body : liquid_below(level, section)) expect_filled(body);
  for (const Outline& body : liquid_below(0.2, test::baffled(0))) expect_filled(body);
}

TEST(Ears, FillWithCornersInARow) {
  Polygons section = test::box(1, 1);
  for (int k = 1; k < 10; ++k) section[0].insert(section[0].begin() + k, Vec<2>(0.1 * k, 0));
  expect_filled(liquid_below(0.5, section)[0]);
}

}  // namespace
}  // namespace seiche::solver::modes
