#include "solver/tank/shapes/extruded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/tank/box.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "solver/tank/shapes/crossings.hpp"
#include "tests/unit/solver/tank/shapes/bodies_checks.hpp"
#include "tests/unit/solver/tank/shapes/wall_points.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
constexpr double l0 = 0.01;
constexpr int layers = 3;
constexpr double reach = 3.1 * l0;

const std::vector<Vec<2>> step{{0, 0}, {0.12, 0}, {0.12, 0.06}, {0.2, 0.06}, {0.2, 0.15}, {0, 0.15}};
const std::vector<Vec<2>> chamfered{{0.043, 0}, {0.157, 0}, {0.2, 0.043}, {0.2, 0.15}, {0, 0.15}, {0, 0.043}};

/// A cylinder of radius 0.1 along z, without heads.
Extruded round_tank() {
  const Vec<2> low(0, 0), high(0, 0.2);
  return {Section(Contour({{{low, high, 1, 0}, {high, low, 1, 0}}}), {"shell"}), -0.06, 0.06};
}

TEST(Extruded, OfABoxHasTheBoxesLatticeBehindItsWalls) {
  Parameters p;
  p.tank = {.length = 0.2, .height = 0.15, .width = 0.12, .closed = true};
  test::expect_same<3>(prism({{0, 0}, {0.2, 0}, {0.2, 0.15}, {0, 0.15}}, 0.12).wall_points(layers, l0, reach),
                       Box<3>(p).wall_points(layers, l0, reach), l0);
}

// The layer o behind a wall of length L(o) and a section A(o), both enlarged by o: L(o) (w + 2 o) + 2 A(o).
TEST(Extruded, WeightsOfEachLayerSumToItsArea) {
  const auto check = [&](const Extruded& tank, const auto& length, double area) {
    const auto sums = test::layer_weights(tank.wall_points(layers, l0, reach), layers);
    for (int k = 0; k < layers; ++k) {
      const double o = (k + 0.5) * l0, w = tank.z_high() - tank.z_low();
      const double enlarged = area + 0.5 * (length(0.) + length(o)) * o;
      const double exact = length(o) * (w + 2 * o) + 2 * enlarged;
      EXPECT_NEAR(sums[static_cast<std::size_t>(k)] * l0 * l0 / exact, 1, 0.002) << k;
    }
  };
  check(
      round_tank(), [](double o) { return 2 * pi * (0.1 + o); }, pi * 0.01);
  const Extruded chamfer = prism(chamfered, 0.1134);
  check(
      chamfer,
      [](double o) { return 0.2 + 0.114 + 2 * 0.107 + 2 * std::sqrt(2) * 0.043 + o * (4 + 8 * std::tan(pi / 8)); },
      chamfer.section().area());
}

TEST(Extruded, PointsAreAtTheirLayersAndNotTooNear) {
  for (const Extruded& tank : {round_tank(), prism(chamfered, 0.1134), prism(step, 0.08)}) {
    const auto points = tank.wall_points(layers, l0, reach);
    test::expect_at_their_layers<3>(tank, points, l0);
    EXPECT_GT(test::least_gap(points), 0.6 * l0);
  }
}

TEST(Extruded, FacesOfAConvexEdgeGoAlongZ) {
  for (const auto& point : prism(step, 0.08).wall_points(layers, l0, reach))
    for (const auto& face : point.faces) EXPECT_EQ(face.normal[2], 0);
}

TEST(Extruded, DistancesAreExact) {
  test::expect_exact_distances(round_tank(), 200, 0.13);
  const Extruded tank = prism(step, 0.08);
  // Beyond an edge and a corner, and inside beside the end.
  EXPECT_NEAR(tank.nearest({-0.03, 0.1, 0.12}).distance, 0.05, 1e-15);
  EXPECT_NEAR(tank.nearest({-0.03, -0.04, 0.08 + 0.12}).distance, 0.13, 1e-15);
  EXPECT_NEAR(tank.nearest({0.05, 0.05, 0.07}).distance, -0.01, 1e-15);
  EXPECT_EQ(tank.nearest({0.05, 0.05, 0.07}).normal, Vec<3>(0, 0, 1));
  EXPECT_EQ(tank.nearest({0.05, 0.05, 0.07}).patch, 7);
  EXPECT_NEAR(tank.nearest({0.15, 0.03, 0.04}).distance, 0.03, 1e-15) << "in the step";
}

TEST(Extruded, SurfaceIsClosedFacesOutwardsAndHoldsTheVolume) {
  std::vector<std::vector<Edge>> loops = polygon(chamfered).loops();
  const Vec<2> low(0.1, 0.05), high(0.1, 0.11);
  loops.push_back({{low, high, 1, 0}, {high, low, 1, 0}});
  const Extruded with_column(Section(Contour(loops), std::vector<std::string>(6, "wall")), 0.1, 0.2);
  for (const Extruded& tank : {round_tank(), prism(step, 0.08), prism(chamfered, 0.1), with_column}) {
    const test::Enclosed inside = test::enclosed(tank.surface());
    EXPECT_LT(inside.normal.norm(), 1e-12);
    EXPECT_NEAR(inside.volume / tank.volume(), 1, 1e-4);
  }
  EXPECT_NEAR(with_column.volume(), 0.1 * (0.03 - 0.043 * 0.043 - pi * 0.03 * 0.03), 1e-15);
}

TEST(FilledRows, FillASectionWithItsArea) {
  const Section tank = round_tank().section();
  double sum = 0;
  for (const AreaPoint& point : filled_rows(tank.wall(), l0)) {
    EXPECT_LT(tank.nearest(point.position).distance, 0);
    EXPECT_GT(point.area, 0.7 * l0 * l0);
    EXPECT_LT(point.area, 1.3 * l0 * l0);
    sum += point.area;
  }
  EXPECT_NEAR(sum, pi * 0.01, 1e-14);
}

TEST(Crossings, LieWhereTheWallDoes) {
  const Contour wall = round_tank().section().wall();
  for (double y = -0.013; y < 0.23; y += 0.0171) {
    const auto found = crossings(wall, 1, y);
    ASSERT_EQ(found.size(), y > 0 && y < 0.2 ? 2u : 0u);
    for (const Crossing& crossing : found) EXPECT_NEAR(std::hypot(crossing.at, y - 0.1), 0.1, 1e-14);
  }
}

}  // namespace
}  // namespace seiche::solver
