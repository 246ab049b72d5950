#include "solver/tank/baffles/baffled_body.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "solver/operators/interactions.hpp"
#include "solver/tank/filling.hpp"
#include "solver/tank/level.hpp"
#include "tests/unit/solver/expect_refused.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
using Baffle = Parameters::Tank::Baffle;

constexpr double l0 = 0.02;

/// A box of 14 x 10 x 10 spacings, filled to 6.
Parameters box() {
  Parameters p;
  p.particles.spacing = l0;
  p.tank.length = 0.28;
  p.tank.height = p.tank.width = 0.2;
  p.fluid.depth = 0.12;
  return p;
}

Parameters with(Baffle baffle) {
  Parameters p = box();
  p.tank.baffles = {std::move(baffle)};
  return p;
}

/// Upright at x from z = low to z = high, up to a height.
Baffle upright(double x, double low, double high, double top, double thickness) {
  return {.thickness = thickness, .corners = {{x, 0, low}, {x, 0, high}, {x, top, high}}};
}

TEST(BaffledBody, ItsSurfaceLeavesOutWhatIsWithinBaffles) {
  const double whole = 0.28 * 0.2 * 0.2, area = 2 * (0.28 * 0.2 * 2 + 0.2 * 0.2);
  const SurfaceMesh thick = wall_surface(with(upright(0.14, 0, 0.2, 0.08, 0.04)));
  EXPECT_NEAR(volume_of(thick), whole - 0.04 * 0.08 * 0.2, 1e-9);
  EXPECT_NEAR(area_of(thick), area + 2 * 0.08 * 0.2 - 2 * 0.04 * 0.08, 1e-6);
  EXPECT_NEAR(volume_below(thick, 0.05), 0.05 * 0.2 * (0.28 - 0.04), 1e-9);
  EXPECT_EQ(thick.patches.back().name, "baffle");
  const SurfaceMesh plate = wall_surface(with(upright(0.14, 0, 0.2, 0.08, 0)));
  EXPECT_NEAR(volume_of(plate), whole, 1e-9);
  EXPECT_NEAR(area_of(plate), area + 2 * 0.08 * 0.2, 1e-6) << "both sides";
  const SurfaceMesh beyond = wall_surface(with(upright(0.14, -0.3, 0.7, 0.08, 0.04)));
  EXPECT_NEAR(volume_of(beyond), whole - 0.04 * 0.08 * 0.2, 1e-7) << "what goes beyond the wall doesn't count";
  const SurfaceMesh free = wall_surface(with({.thickness = 0.04,
                                              .centre = {0.14, 0.1, 0.1},
                                              .normal = {0, 1, 0},
                                              .radius = 0.06,
                                              .holes = {{0.14, 0.1, 0.1, 0.03}}}));
  const double ring = pi * (0.06 * 0.06 - 0.03 * 0.03);
  EXPECT_NEAR(volume_of(free), whole - 0.04 * ring, 1e-8);
  EXPECT_NEAR(area_of(free), area + 2 * ring + 2 * pi * 0.09 * 0.04, 1e-4 * area);
}

TEST(BaffledBody, ARingInACylinder) {
  Parameters p;
  p.particles.spacing = l0;
  p.tank = {.shape = TankShape::cylinder, .length = 0.4, .height = 0, .radius = 0.25};
  p.tank.rings = {{.centre = {0, 0.2, 0}, .inner = 0.2, .thickness = 0.01}};
  p.fluid.depth = 0.3;
  const double ring = pi * (0.25 * 0.25 - 0.2 * 0.2);
  const SurfaceMesh wall = wall_surface(p);
  EXPECT_NEAR(volume_of(wall), pi * 0.25 * 0.25 * 0.4 - 0.01 * ring, 2e-4 * volume_of(wall));
  EXPECT_EQ(wall.patches.back().name, "ring");
  const auto tank = make_shape<3>(p);
  EXPECT_NEAR(tank->nearest({0, 0.25, 0.22}).distance, -0.03, 1e-9);
  EXPECT_NEAR(tank->nearest({0.1, 0.203, 0}).distance, -0.1, 1e-9);
  EXPECT_NEAR(tank->nearest({0.22, 0.2, 0}).distance, 0.005, 1e-9) << "within it";
  p.tank.rings[0].thickness = 0;
  const SurfaceMesh thin = wall_surface(p);
  EXPECT_NEAR(area_of(thin), pi * (2 * 0.25 * 0.25 + 0.5 * 0.4) + 2 * ring, 2e-3);
}

/// Number density of each fluid particle, by its place.
std::map<std::array<long, 3>, double> densities(const Parameters& p) {
  State<3> s = fill_tank<3>(p);
  const double rim = wall_layers(p.method) * l0;
  Interactions<3> near(p, Vec<3>::Constant(-rim), Vec<3>(0.28 + rim, 0.2 + rim, 0.2 + rim), longest_support(p.method));
  near.list.build(s);
  near.measure(s);
  std::map<std::array<long, 3>, double> all;
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    if (s.kind[i] != Kind::fluid) continue;
    double sum = 0;
    near.density.pairs->each(i, s, [&](int j, const Vec<3>& r, double w) { sum += s.volume[j] * w * r.squaredNorm(); });
    const Vec<3>& r = s.position[i];
    all[{std::lround(1e6 * r[0]), std::lround(1e6 * r[1]), std::lround(1e6 * r[2])}] = sum;
  }
  return all;
}

// On the lattice each particle has a whole neighbourhood, as in 2-D.
TEST(BaffledBody, LiquidBesideBafflesLacksNoNeighbours) {
  const auto whole = densities(box());
  for (const Baffle& baffle : {upright(0.14, 0, 0.2, 0.08, 0), upright(0.14, 0, 0.2, 0.2, 0),
                               upright(0.14, 0.04, 0.16, 0.08, 0), upright(0.14, 0, 0.12, 0.06, 2 * l0)}) {
    const auto here = densities(with(baffle));
    const double solid = baffle.thickness * baffle.corners[2][1] * baffle.corners[1][2];
    EXPECT_EQ(here.size(), whole.size() - std::lround(solid / (l0 * l0 * l0)));
    // Behind a baffle that reaches above the level solids count there, too; they are dry.
    for (const auto& [place, density] : here)
      if (baffle.corners[2][1] < 0.12 || place[1] < 60000) {
        EXPECT_NEAR(density, whole.at(place), 1e-9 * density) << place[0] << ' ' << place[1] << ' ' << place[2];
      }
  }
}

TEST(BaffledBody, OneAcrossTheTankIsTheRectangleOfItsPlace) {
  const Parameters p = with({.thickness = 0.04, .x = 0.14, .height = 0.08});
  EXPECT_NEAR(volume_of(wall_surface(p)), 0.28 * 0.2 * 0.2 - 0.04 * 0.08 * 0.2, 1e-9);
}

TEST(BaffledBody, WhatNoRunCanHaveIsRefused) {
  test::expect_refused(with(upright(0.5, 0, 0.2, 0.1, 0)), {"baffle", "(0.5, 0.05, 0.1) m", "outside the tank"});
  test::expect_refused(with(upright(0.14, 0.03, 0.2, 0.1, 0)),
                       {"gap of 0.03 m", "tank's wall", "1.5 spacings", "particles.spacing = 0.015"});
  test::expect_refused(with({.centre = {0.14, 0.1, 0.1}, .radius = 0.06, .holes = {{0.14, 0.1, 0.1, 0.01}}}),
                       {"(0.14, 0.1, 0.1) m", "hole", "0.02 m wide", "particles.spacing = 0.01"});
  test::expect_refused(with({.centre = {0.14, 0.1, 0.1}, .radius = 0.005}), {"0.01 m wide", "particles.spacing"});
  test::expect_refused(with({.points = {{0.1, 0}, {0.1, 0.1}}}), {"points", "corners", "tank.section"});
  test::expect_refused(with({}), {"nothing", "points", "corners"});
  Parameters two = with(upright(0.14, 0, 0.2, 0.08, 0));
  two.tank.baffles.push_back({.corners = {{0.14, 0.11, 0}, {0.14, 0.11, 0.2}, {0.14, 0.2, 0.2}}});
  test::expect_refused(two, {"gap of 0.03 m", "another baffle"});
  two.tank.baffles[1].corners = {{0.14, 0.08, 0}, {0.14, 0.08, 0.2}, {0.14, 0.2, 0.2}};
  EXPECT_NO_THROW(check_parameters(two)) << "they touch";
  Parameters ring = box();
  ring.tank.rings = {{.centre = {0.14, 0.1, 0.1}, .inner = 0.08, .outer = 0.06}};
  test::expect_refused(ring, {"ring", "0.08", "0.06"});
  ring.tank.width = 0;
  test::expect_refused(ring, {"ring", "3-D"});
}

}  // namespace
}  // namespace seiche::solver
