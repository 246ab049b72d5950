#include "solver/modes/cut_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "solver/modes/section_modes.hpp"
#include "solver/tank/edge.hpp"
#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

double area(const Polygons& loops) {
  double twice = 0;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) twice += cross(loop[k], loop[(k + 1) % loop.size()]);
  return 0.5 * twice;
}

std::vector<Vec<2>> rectangle(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

double first(const Polygons& section) { return section_modes(section, 0.2, 1, 1)[0].modes[0].frequency; }

TEST(CutOut, OfNothingIsTheSection) {
  EXPECT_EQ(cut_out(test::box(0.5, 0.3), {}, {}).size(), 1u);
  EXPECT_NEAR(area(cut_out(test::circle(0.25), {}, {})), area(test::circle(0.25)), 1e-12);
}

TEST(CutOut, OfABaffleThatEndsOnTheFloorOrBelow) {
  for (const double foot : {0.0, -0.05, 1e-13, -1e-13}) {
    const auto loops = cut_out(test::box(0.5, 0.3), {rectangle(0.24, 0.26, foot, 0.1)}, {});
    ASSERT_EQ(loops.size(), 1u) << foot;
    EXPECT_NEAR(area(loops), 0.15 - 0.002, 1e-9);
    EXPECT_NEAR(first(loops), first(test::baffled(0.02)), 1e-4);
  }
}

TEST(CutOut, OfAWallOverANarrowGapJoinsTheChambersSlowly) {
  // Nearly a bath with a leak: the narrower the gap, the slower the first wave (a pipe's inertia).
  double last = 0;
  for (const double gap : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    const auto loops = cut_out(test::box(0.5, 0.3), {rectangle(0.24, 0.26, gap, 0.4)}, {});
    const double now = first(loops);
    EXPECT_GT(now, last);
    // omega^2 = 2 g (gap / length) / breadth of each chamber, if all inertia is in the gap.
    const double expected = std::sqrt(2 * gap / 0.02 / 0.24);
    if (gap == 1e-6 || gap == 1e-5) {
      EXPECT_NEAR(now / expected, 1, 0.01) << gap;
    }
    last = now;
  }
}

TEST(CutOut, OfABaffleAlongTheWall) {
  EXPECT_NEAR(area(cut_out(test::box(0.5, 0.3), {rectangle(0, 0.1, 0, 0.1)}, {})), 0.14, 1e-12);
  EXPECT_NEAR(area(cut_out(test::box(0.5, 0.3), {rectangle(-0.1, 0, 0, 0.1)}, {})), 0.15, 1e-12);
}

TEST(CutOut, OfAWallThroughTheTankLeavesTwo) {
  const auto loops = cut_out(test::box(0.5, 0.3), {rectangle(0.24, 0.26, -1, 1)}, {});
  EXPECT_EQ(loops.size(), 2u);
  EXPECT_EQ(section_modes(loops, 0.2, 1, 1).size(), 2u);
}

TEST(CutOut, OfAPlateThatEndsOnTheFloorOrBelow) {
  for (const double foot : {0.0, -0.05, 1e-13, -1e-13}) {
    const auto loops = cut_out(test::box(0.5, 0.3), {}, {{{0.25, foot}, {0.25, 0.1}}});
    EXPECT_NEAR(first(loops), first(test::baffled(0)), 1e-4) << foot;
  }
}

TEST(CutOut, OfPlatesThatCrossInMidWater) {
  const auto loops = cut_out(test::box(0.5, 0.3), {},
                             {{{0.2, 0.1}, {0.3, 0.1}}, {{0.25, 0.05}, {0.25, 0.15}}, {{0.1, 0.05}, {0.1, 0.1}}});
  EXPECT_EQ(loops.size(), 3u);
  EXPECT_NEAR(area(loops), 0.15, 1e-12);
  EXPECT_LT(first(loops), first(test::box(0.5, 0.3)));
}

TEST(CutOut, OfAPlateAlongTheWallOrWithinASolidIsNothing) {
  EXPECT_EQ(cut_out(test::box(0.5, 0.3), {}, {{{0, 0.1}, {0, 0.2}}}).size(), 1u);
  const auto loops = cut_out(test::box(0.5, 0.3), {rectangle(0.2, 0.3, 0.1, 0.2)}, {{{0.22, 0.15}, {0.28, 0.15}}});
  EXPECT_EQ(loops.size(), 2u);
}

TEST(CutOut, OfABaffleOfManyPlatesAndSolidsHasTheAreaOfPointsThatAreLeft) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1), size(0.05, 0.3);
  for (int run = 0; run < 20; ++run) {
    Polygons solids;
    // On a lattice for every other run, where sides coincide.
    const auto number = [&](double x) { return run % 2 ? std::round(20 * x) / 20 : x; };
    for (int k = 0; k < 8; ++k) {
      const double left = number(place(random)), low = number(place(random));
      const auto right = left + std::max(number(size(random)), 0.05), high = low + std::max(number(size(random)), 0.05);
      solids.push_back(rectangle(left, right, low, high));
    }
    const double left_over = area(cut_out(test::box(1, 1), solids, {}));
    // Exact, by the rectangles that all sides cut the box into.
    std::vector<double> xs{0, 1}, ys{0, 1};
    for (const auto& solid : solids) {
      for (const double x : {solid[0][0], solid[2][0]}) xs.push_back(std::min(x, 1.0));
      for (const double y : {solid[0][1], solid[2][1]}) ys.push_back(std::min(y, 1.0));
    }
    std::sort(xs.begin(), xs.end());
    std::sort(ys.begin(), ys.end());
    double expected = 0;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
      for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
        const Vec<2> r(0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[j] + ys[j + 1]));
        if (std::none_of(solids.begin(), solids.end(), [&](const auto& solid) {
              return (r.array() > solid[0].array()).all() && (r.array() < solid[2].array()).all();
            }))
          expected += (xs[i + 1] - xs[i]) * (ys[j + 1] - ys[j]);
      }
    EXPECT_NEAR(left_over, expected, 1e-7) << run;
  }
}

}  // namespace
}  // namespace seiche::solver::modes
