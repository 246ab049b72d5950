#include "solver/tank/baffles/baffled.hpp"

#include <gtest/gtest.h>

#include "solver/operators/interactions.hpp"
#include "solver/tank/box.hpp"
#include "solver/tank/facets.hpp"
#include "solver/tank/filling.hpp"
#include "solver/tank/level.hpp"
#include "tests/unit/solver/expect_refused.hpp"

namespace seiche::solver {
namespace {

constexpr double l0 = 0.01;

/// A box of 30 x 20 spacings, half full.
Parameters box() {
  Parameters p;
  p.particles.spacing = l0;
  p.tank.length = 0.3;
  p.tank.height = 0.2;
  p.fluid.depth = 0.1;
  return p;
}

Parameters with(Parameters::Tank::Baffle baffle) {
  Parameters p = box();
  p.tank.baffles = {std::move(baffle)};
  return p;
}

TEST(Baffled, ItsSurfaceLeavesOutWhatIsWithinBaffles) {
  const SurfaceMesh thick = wall_surface(with({{{0.1, 0}, {0.1, 0.08}}, 0.02}));
  EXPECT_NEAR(volume_of(thick), 0.3 * 0.2 - 0.02 * 0.08, 1e-12);
  EXPECT_NEAR(area_of(thick), 2 * (0.3 + 0.2) + 2 * 0.08, 1e-9);
  EXPECT_NEAR(volume_below(thick, 0.05), 0.05 * (0.3 - 0.02), 1e-12);
  ASSERT_EQ(thick.patches.size(), 5u);
  EXPECT_EQ(thick.patches.back().name, "baffle");
  const SurfaceMesh plate = wall_surface(with({{{0.1, 0}, {0.1, 0.08}}, 0}));
  EXPECT_NEAR(volume_of(plate), 0.3 * 0.2, 1e-12);
  EXPECT_NEAR(area_of(plate), 2 * (0.3 + 0.2) + 2 * 0.08, 1e-9) << "both sides";
}

TEST(Baffled, OneThatStandsFreeAndOneThatGoesBeyondTheWall) {
  const SurfaceMesh free = wall_surface(with({{{0.1, 0.05}, {0.1, 0.15}}, 0.02}));
  EXPECT_NEAR(volume_of(free), 0.3 * 0.2 - 0.02 * 0.1, 1e-12);
  EXPECT_NEAR(area_of(free), 1 + 2 * (0.02 + 0.1), 1e-9);
  const SurfaceMesh through = wall_surface(with({{{0.1, -1}, {0.1, 0.08}}, 0.02}));
  EXPECT_NEAR(volume_of(through), 0.3 * 0.2 - 0.02 * 0.08, 1e-12);
}

TEST(Baffled, ASlantedOneMeetsTheWallWithAllOfItsEnd) {
  // Each side is 0.04 sqrt(2) beside the line at 45 degrees from (0.1, 0): their feet are 0.02 sqrt(2) apart.
  const SurfaceMesh wall = wall_surface(with({{{0.1, 0}, {0.15, 0.05}}, 0.02}));
  const double length = 0.05 * std::sqrt(2);
  EXPECT_NEAR(volume_of(wall), 0.3 * 0.2 - 0.02 * length, 1e-12) << "triangles at the foot cancel";
}

TEST(Baffled, OneAcrossTheTankIsALineUpFromTheFloor) {
  const SurfaceMesh wall = wall_surface(with({.thickness = 0.02, .x = 0.1, .height = 0.08}));
  EXPECT_NEAR(volume_of(wall), 0.3 * 0.2 - 0.02 * 0.08, 1e-12);
}

TEST(Baffled, ASectionHasWhatItCutsOfARing) {
  Parameters p = box();
  p.tank = {.shape = TankShape::cylinder, .length = 0.4, .height = 0, .radius = 0.25};
  p.tank.rings = {{.centre = {0, 0.2, 0}, .inner = 0.2}};
  p.tank.section = SectionPlane{Axis::z, 0};
  const SurfaceMesh through_axis = wall_surface(p);
  EXPECT_NEAR(area_of(through_axis), 2 * (0.5 + 0.4) + 2 * 2 * 0.05, 1e-9) << "both sides of both parts";
  EXPECT_EQ(through_axis.patches.back().name, "ring_2");
  p.tank.section->at = 0.22;
  const SurfaceMesh beside = wall_surface(p);
  const double width = 2 * std::sqrt(0.25 * 0.25 - 0.22 * 0.22);
  EXPECT_NEAR(area_of(beside), 2 * (width + 0.4) + 2 * width, 1e-6) << "past its opening";
  EXPECT_EQ(beside.patches.back().name, "ring");
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(Baffled, ItsDistanceIsThatToTheNearestWall) {
  const auto tank = make_shape<2>(with({{{0.1, 0}, {0.1, 0.08}}, 0.02}));
  EXPECT_NEAR(tank->nearest({0.12, 0.05}).distance, -0.01, 1e-12);
  EXPECT_LT((tank->nearest({0.12, 0.05}).normal - Vec<2>(-1, 0)).norm(), 1e-12);
  EXPECT_NEAR(tank->nearest({0.1, 0.075}).distance, 0.005, 1e-12) << "within it";
  EXPECT_NEAR(tank->nearest({0.29, 0.1}).distance, -0.01, 1e-12);
  EXPECT_NEAR(tank->nearest({0.1, -0.01}).distance, 0.01, 1e-3) << "below the floor";
  EXPECT_NEAR(make_shape<2>(with({{{0.1, 0}, {0.1, 0.08}}, 0}))->nearest({0.101, 0.05}).distance, -0.05, 1e-12)
      << "a plate is no wall to it";
}

/// Number density of each fluid particle, by its place.
std::map<std::pair<long, long>, double> densities(const Parameters& p) {
  State<2> s = fill_tank<2>(p);
  const double rim = wall_layers(p.method) * l0;
  Interactions<2> near(p, Vec<2>::Constant(-rim), Vec<2>(0.3 + rim, 0.2 + rim), longest_support(p.method));
  near.list.build(s);
  near.measure(s);
  std::map<std::pair<long, long>, double> all;
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    if (s.kind[i] != Kind::fluid) continue;
    double sum = 0;
    near.density.pairs->each(i, s, [&](int j, const Vec<2>& r, double w) { sum += s.volume[j] * w * r.squaredNorm(); });
    all[{std::lround(1e6 * s.position[i][0]), std::lround(1e6 * s.position[i][1])}] = sum;
  }
  return all;
}

// On the lattice each particle has a whole neighbourhood, of liquid and of the solids that it sees: what it has in the
// tank without a baffle.
TEST(Baffled, LiquidBesideBafflesLacksNoNeighbours) {
  const auto whole = densities(box());
  for (const Parameters::Tank::Baffle& baffle : std::vector<Parameters::Tank::Baffle>{
           {{{0.1, 0}, {0.1, 0.06}}, 0},
           {{{0.1, 0}, {0.1, 0.2}}, 0},
           {{{0.1, 0.03}, {0.1, 0.07}}, 0},
           {{{0.05, 0.05}, {0.15, 0.05}}, 0},
           {{{0, 0.05}, {0.1, 0.05}, {0.1, 0.08}}, 0},
           {{{0.105, 0}, {0.105, 0.06}}, l0},
           {{{0.1, 0}, {0.1, 0.06}}, 2 * l0},
       }) {
    const auto here = densities(with(baffle));
    EXPECT_EQ(here.size(),
              baffle.thickness > 0 ? whole.size() - std::lround(0.06 * baffle.thickness / (l0 * l0)) : whole.size());
    // Behind a baffle that reaches above the level solids count there, too; they are dry.
    for (const auto& [place, density] : here)
      if (baffle.points.back()[1] < 0.1 || place.second < 70000) {
        EXPECT_NEAR(density, whole.at(place), 1e-9) << place.first << ' ' << place.second << " um; baffle from "
                                                    << baffle.points[0][0] << ' ' << baffle.points[0][1];
      }
  }
}

// A divider 1 l0 thick whose sides lie in the middle of cells: of the floor below each chamber as much counts as it is
// long.
TEST(Baffled, CutsTheWallsPointsWhereItsSidesMeetThem) {
  const auto tank = make_shape<2>(with({{{0.1, -0.1}, {0.1, 0.3}}, l0}));
  double left = 0, right = 0;
  for (const WallPoint<2>& point : tank->wall_points(1, l0, 3.6 * l0)) {
    if (point.behind >= 0 || point.position[1] > 0 || point.normal[1] != -1) continue;
    if (point.position[0] < 0.095) left += point.weight;
    if (point.position[0] > 0.105) right += point.weight;
  }
  EXPECT_NEAR(left * l0, 0.095, 1e-9);
  EXPECT_NEAR(right * l0, 0.3 - 0.105, 1e-9);
}

TEST(Baffled, ADividedBoxIsTwoBoxes) {
  Parameters left = box();
  left.tank.length = 0.1;
  const Box<2> alone(left);
  const auto points = make_shape<2>(with({{{0.1, 0}, {0.1, 0.2}}, 0}))->wall_points(3, l0, 3 * l0);
  // Of the box's wall points those behind its right wall are the left side's, its corners included.
  int behind = 0;
  for (const auto& point : alone.wall_points(3, l0, 3 * l0)) {
    if (point.position[0] < 0.1 ||
        (point.position - Vec<2>(0.1, std::clamp(point.position[1], 0., 0.2))).norm() >= 3 * l0)
      continue;
    ++behind;
    EXPECT_EQ(std::count_if(points.begin(), points.end(),
                            [&](const auto& other) {
                              return other.behind == 1 && (other.position - point.position).norm() < 1e-12 &&
                                     std::abs(other.weight - point.weight) < 1e-12;
                            }),
              1)
        << point.position.transpose();
  }
  EXPECT_GT(behind, 60);
}

TEST(Baffled, CellsThatAPlateCutsHaveTheirShareOnEachSide) {
  for (const double x : {0.1, 0.103, 0.1067}) {
    const State<2> s = fill_tank<2>(with({{{x, 0}, {x, 0.2}}, 0}));
    long left = 0, all = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.kind[i] != Kind::fluid) continue;
      ++all;
      left += s.position[i][0] < x;
      EXPECT_GT(std::abs(s.position[i][0] - x), 0.0999 * l0);
    }
    EXPECT_EQ(all, 300);
    EXPECT_NEAR(static_cast<double>(left) * l0 * l0, 0.1 * x, 0.6 * l0 * l0) << x;
  }
}

TEST(Baffled, WhatNoRunCanHaveIsRefused) {
  test::expect_refused(with({{{0.5, 0}, {0.5, 0.1}}, 0}), {"(0.5, 0) m", "outside the tank", "x from 0 to 0.3 m"});
  test::expect_refused(with({{{0.1, 0.1}, {0.105, 0.1}}, 0}), {"0.005 m long", "0.5 spacings", "particles.spacing"});
  test::expect_refused(with({{{0.1, 0.012}, {0.1, 0.1}}, 0}), {"gap of 0.012 m", "(0.1, 0.012) m", "tank's wall",
                                                               "1.2 spacings", "particles.spacing = 0.006"});
  test::expect_refused(with({{{0.015, 0.05}, {0.015, 0.1}}, 0.01}), {"gap of 0.01", "tank's wall"});
  Parameters two = with({{{0.1, 0}, {0.1, 0.05}}, 0});
  two.tank.baffles.push_back({{{0.1, 0.065}, {0.1, 0.1}}, 0});
  test::expect_refused(two, {"gap of 0.015 m", "another baffle", "1.5 spacings"});
  two.tank.baffles[1].points[0][1] = 0.05;
  EXPECT_NO_THROW(check_parameters(two)) << "they touch";
  Parameters body = with({{{0.1, 0}, {0.1, 0.05}}, 0});
  body.tank.width = 0.1;
  test::expect_refused(body, {"tank.baffle", "2-D", "corners", "tank.section"});
  Parameters paper = with({{{0.1, 0}, {0.1, 0.05}}, 0});
  paper.method.wall_model = WallModel::particles;
  test::expect_refused(paper, {"tank.baffle", "wall_model", "ghosts"});
}

}  // namespace
}  // namespace seiche::solver
