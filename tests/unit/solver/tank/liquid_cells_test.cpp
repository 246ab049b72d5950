#include "solver/tank/liquid_cells.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/tank/shapes/built_in.hpp"
#include "solver/tank/shapes/slice.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
using test::l0;

TEST(LiquidLattice, FillsABoxOfWholeSpacings) {
  const LiquidLattice<2> lattice({{0, 0}, {0.2, 0.15}}, 0.1, l0);
  EXPECT_EQ(lattice.corner, Vec<2>(0, 0));
  EXPECT_EQ(lattice.count, (LiquidLattice<2>::Cell(20, 10)));
}

TEST(LiquidLattice, HangsFromTheLevelAndLiesAboutTheMiddle) {
  const LiquidLattice<2> lattice({{-0.1, 0.3}, {0.107, 0.5}}, 0.4042, l0);
  EXPECT_EQ(lattice.count, (LiquidLattice<2>::Cell(21, 11)));
  EXPECT_NEAR(lattice.corner[1] + 11 * l0, 0.4042, 1e-15);
  EXPECT_NEAR(lattice.corner[0] + 10.5 * l0, 0.0035, 1e-15);
}

TEST(PartInside, IsExactWhereAWallCutsAlongAnAxis) {
  const Section tank = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1).section();
  const auto [share, centroid] = part_inside(tank, Vec<2>(0.002, 0.5), l0);
  EXPECT_NEAR(share, 0.7, 1e-12);
  EXPECT_NEAR(centroid[0], 0.0035, 3e-3 * l0) << "l0/8 (1/2 - 1/8) of a part that is cut, of 0.7 times 8 parts";
  EXPECT_EQ(part_inside(tank, Vec<2>(0.5, 0.5), l0).share, 1);
  EXPECT_EQ(part_inside(tank, Vec<2>(0.005, 0.005), l0).share, 1);
  EXPECT_EQ(part_inside(tank, Vec<2>(-0.1, 0.5), l0).share, 0);
}

TEST(PartInside, AddsUpToTheTank) {
  const Section disc = slice(cylinder(0.05, 1, Axis::z, Head::flat), {Axis::z, 0});
  double cells = 0;
  const LiquidLattice<2> lattice(disc.bounds(), 0.1, 0.0093);
  lattice.each([&](const auto& cell) { cells += part_inside(disc, lattice.centre(cell), 0.0093).share; });
  EXPECT_NEAR(cells * 0.0093 * 0.0093, pi * 0.05 * 0.05, 1e-3 * pi * 0.05 * 0.05);
  const Revolved ball = sphere(0.05);
  double cubes = 0;
  const LiquidLattice<3> room(ball.bounds(), 0.1, 0.0093);
  room.each([&](const auto& cell) { cubes += part_inside(ball, room.centre(cell), 0.0093).share; });
  EXPECT_NEAR(cubes * std::pow(0.0093, 3), 4. / 3 * pi * std::pow(0.05, 3), 2e-3 * 4. / 3 * pi * std::pow(0.05, 3));
}

TEST(CutCells, KeepTheirShareEvenlyAndInAll) {
  CutCells<2> cut;
  for (int y = 0; y < 100; ++y) cut.add({0, y}, 0, 0.3, {0, 0}), cut.add({9, y}, 0, 0.3, {0, 0});
  cut.choose(60);
  for (const int x : {0, 9}) {
    int kept = 0, longest = 0, gap = 0;
    for (int y = 0; y < 100; ++y) {
      kept += cut.has_particle({x, y}, 0);
      gap = cut.has_particle({x, y}, 0) ? 0 : gap + 1;
      longest = std::max(longest, gap);
    }
    EXPECT_EQ(kept, 30) << "each wall has what lies beside it";
    EXPECT_LE(longest, 3);
  }
}

TEST(CutCells, MeetANumberThatSharesMiss) {
  for (const long wanted : {57l, 63l}) {
    CutCells<2> cut;
    for (int y = 0; y < 200; ++y) cut.add({0, y}, 0, 0.3, {0, 0});
    cut.choose(wanted);
    long kept = 0;
    for (int y = 0; y < 200; ++y) kept += cut.has_particle({0, y}, 0);
    EXPECT_EQ(kept, wanted);
  }
}

}  // namespace
}  // namespace seiche::solver
