#include "solver/tank/shapes/section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "solver/tank/box.hpp"
#include "tests/unit/solver/tank/shapes/wall_points.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;
using test::layer_weights;
constexpr double l0 = 0.01;
constexpr int layers = 4;
constexpr double reach = 3.1 * l0;

Section of_points(const std::vector<Vec<2>>& points) {
  return {polygon(points), std::vector<std::string>(points.size(), "wall")};
}

Section circle(double radius, const Vec<2>& centre = Vec<2>::Zero()) {
  const Vec<2> low = centre - Vec<2>(0, radius), high = centre + Vec<2>(0, radius);
  return {Contour({{{low, high, 1, 0}, {high, low, 1, 0}}}), {"shell"}};
}

// 20 x 15 spacings; a step of 8 x 6 at the right of it; its lower corners cut.
const std::vector<Vec<2>> box{{0, 0}, {0.2, 0}, {0.2, 0.15}, {0, 0.15}};
const std::vector<Vec<2>> step{{0, 0}, {0.12, 0}, {0.12, 0.06}, {0.2, 0.06}, {0.2, 0.15}, {0, 0.15}};
const std::vector<Vec<2>> chamfered{{0.043, 0}, {0.157, 0}, {0.2, 0.043}, {0.2, 0.15}, {0, 0.15}, {0, 0.043}};

TEST(Section, OfABoxHasTheBoxesLatticeBehindItsWalls) {
  Parameters p;
  p.tank = {.length = 0.2, .height = 0.15, .width = 0, .closed = true};
  test::expect_same<2>(of_points(box).wall_points(layers, l0, reach), Box<2>(p).wall_points(layers, l0, reach), l0);
}

TEST(Section, OfAStepHasALatticeToo) {
  const Section tank = of_points(step);
  const auto points = tank.wall_points(layers, l0, reach);
  for (const auto& point : points) {
    for (const double x : point.position) EXPECT_NEAR(x / l0 - 0.5, std::round(x / l0 - 0.5), 1e-6);
    EXPECT_NEAR(point.weight, 1, 1e-6) << point.position.transpose();
  }
  // Layer k of the lattice has 4 more cells than the one before; the convex corner of the solid takes one corner's away
  // and gives another.
  const auto sums = layer_weights(points, layers);
  for (int k = 0; k < layers; ++k) EXPECT_NEAR(sums[static_cast<std::size_t>(k)], 70 + 4 + 8 * k, 1e-6) << k;
  EXPECT_GT(test::least_gap(points), (1 - 1e-6) * l0);
  test::expect_at_their_layers(tank, points, l0);
}

/// Length of the curve that lies o behind a polygon: mitred it gains 2 o tan(turn/2) at each corner, round o turn.
double mitred_length(const std::vector<Vec<2>>& points, double o, double sharpest = 1.69) {
  double length = 0;
  const std::size_t count = points.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec<2> a = points[(k + 1) % count] - points[k], b = points[(k + 2) % count] - points[(k + 1) % count];
    const double turn = std::atan2(cross(a, b), a.dot(b));
    length += a.norm() + o * (turn > sharpest ? turn : 2 * std::tan(0.5 * turn));
  }
  return length;
}

TEST(Section, WeightsOfEachLayerSumToItsLength) {
  const std::vector<Vec<2>> triangle{{0, 0}, {0.2, 0}, {0.05, 0.18}};
  const std::vector<Vec<2>> kite{{0, 0}, {0.11, 0.02}, {0.13, 0.17}, {0.03, 0.15}};
  for (const auto& points : {chamfered, step, triangle, kite}) {
    const Section tank = of_points(points);
    const auto sums = layer_weights(tank.wall_points(layers, l0, reach), layers);
    for (int k = 0; k < layers; ++k)
      EXPECT_NEAR(sums[static_cast<std::size_t>(k)] * l0, mitred_length(points, (k + 0.5) * l0), 1e-7) << k;
  }
  const auto sums = layer_weights(circle(0.1).wall_points(layers, l0, reach), layers);
  for (int k = 0; k < layers; ++k)
    EXPECT_NEAR(sums[static_cast<std::size_t>(k)] * l0, 2 * pi * (0.1 + (k + 0.5) * l0), 1e-12);
}

TEST(Section, PointsOfALayerAreAboutASpacingApart) {
  const std::vector<Vec<2>> triangle{{0, 0}, {0.2, 0}, {0.05, 0.18}};
  for (const Section& tank : {of_points(chamfered), circle(0.1), of_points(triangle), of_points(step)}) {
    const auto points = tank.wall_points(layers, l0, reach);
    for (const double gap : test::gaps<2>(points, [](const auto&a, const auto&b) { return a.layer == b.layer; })) {
      EXPECT_GT(gap, 0.8 * l0);
      EXPECT_LT(gap, 1.2 * l0);
    }
    EXPECT_GT(test::least_gap(points), 0.8 * l0);
    test::expect_at_their_layers(tank, points, l0);
  }
}

TEST(Section, OfManyShortEdgesHasItsPointsAsTheCurveHas) {
  std::vector<Vec<2>> points;
  for (int k = 0; k < 200; ++k) points.emplace_back(0.1 * std::sin(pi * k / 100), 0.1 * std::cos(pi * k / 100));
  const Section tank = of_points(points);
  const auto lining = tank.wall_points(layers, l0, reach);
  const auto exact = circle(0.1).wall_points(layers, l0, reach);
  EXPECT_EQ(lining.size(), exact.size());
  EXPECT_GT(test::least_gap(lining), 0.9 * l0);
  for (const auto& point : lining) EXPECT_LT((point.normal - point.position.normalized()).norm(), 0.05);
}

TEST(Section, RoundASolidInTheMiddleLayersEndWhereTheyMeet) {
  // A column of radius 3.2 spacings: layer 3 would lie beyond its centre.
  std::vector<std::vector<Edge>> loops = circle(0.1).wall().loops();
  loops.push_back(circle(0.032).wall().loops()[0]);
  const Section tank(Contour(loops), {"shell"});
  double weight = 0;
  const auto points = tank.wall_points(layers, l0, reach);
  test::expect_at_their_layers(tank, points, l0);
  for (const auto& point : points) weight += point.position.norm() < 0.05 ? point.weight : 0;
  EXPECT_NEAR(weight * l0 * l0, pi * 0.032 * 0.032, 0.05 * pi * 0.032 * 0.032);
}

// A wall between two chambers, thicker and thinner than whole spacings: nothing of it is missing or counted twice.
TEST(Section, TheWallBetweenTwoChambersHasItsWholeWeight) {
  for (const double thickness : {2.0, 2.3, 2.7, 3.0, 3.3, 3.9, 4.0, 4.6}) {
    const double t = thickness * l0;
    std::vector<std::vector<Edge>> loops = polygon({{0, 0}, {0.2, 0}, {0.2, 0.15}, {0, 0.15}}).loops();
    loops.push_back(polygon({{0.2 + t, 0}, {0.4, 0}, {0.4, 0.15}, {0.2 + t, 0.15}}).loops()[0]);
    const Section tank(Contour(loops), {"a", "b", "c", "d"});
    double weight = 0;
    for (const auto& point : tank.wall_points(layers, l0, reach))
      if (point.position[0] > 0.2 && point.position[0] < 0.2 + t && std::abs(point.position[1] - 0.075) < 0.045)
        weight += point.weight;
    EXPECT_NEAR(weight, 9 * thickness, 1e-6) << thickness;
  }
}

TEST(Section, PointsBesideAConvexEdgeOfTheSolidKnowItsFaces) {
  const Section tank = of_points(step);
  const Vec<2> corner(0.12, 0.06);
  int beside = 0;
  for (const auto& point : tank.wall_points(layers, l0, reach)) {
    if ((point.position - corner).norm() > reach) {
      EXPECT_TRUE(point.faces.empty());
      continue;
    }
    ++beside;
    ASSERT_EQ(point.faces.size(), 2u);
    for (const auto& face : point.faces) EXPECT_NEAR(face.behind(corner), 0, 1e-15);
    // A pair from above crosses the step's top, one from the left its side.
    EXPECT_LT((entered_face<2>(point.faces, point.position + Vec<2>(0, 0.1), point.position) - Vec<2>(0, -1)).norm(),
              1e-12);
    EXPECT_LT((entered_face<2>(point.faces, point.position - Vec<2>(0.1, 0), point.position) - Vec<2>(1, 0)).norm(),
              1e-12);
  }
  EXPECT_GT(beside, 5);
}

// KF3 with the default radius; liquid on a lattice along the wall.
double density(const Vec<2>& r, const std::vector<WallPoint<2>>& walls, const Section& tank, double turn) {
  const KF3 w{2.6 * l0};
  const Vec<2> along(std::cos(turn), std::sin(turn)), up(-along[1], along[0]);
  double n = 0;
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      const Vec<2> q = r + l0 * (i * along + j * up);
      if ((i != 0 || j != 0) && tank.nearest(q).distance < 0) n += w((q - r).norm());
    }
  for (const auto& point : walls) n += point.weight * w((point.position - r).norm());
  return n;
}

TEST(Section, NumberDensityBesideItsWallsIsTheLattices) {
  const double n0 = lattice_reference<2>(KF3{2.6 * l0}, l0).n0;
  // A box of whole spacings turned by 20 degrees, and its corner.
  const double turn = pi / 9;
  const Vec<2> along(std::cos(turn), std::sin(turn)), up(-along[1], along[0]);
  std::vector<Vec<2>> turned;
  for (const Vec<2>& corner : box) turned.emplace_back(corner[0] * along + corner[1] * up);
  const Section tank = of_points(turned);
  const auto walls = tank.wall_points(layers, l0, reach);
  for (const double height : {0.5, 1.5, 2.5})
    for (const double place : {0.5, 1.5, 9.5}) {
      const Vec<2> r = l0 * (place * along + height * up);
      EXPECT_NEAR(density(r, walls, tank, turn) / n0, 1, 1e-9) << height << ' ' << place;
    }
  // The chamfer is 6.08 spacings long, and its layers hold whole numbers of points: beside it within 3 %, three
  // spacings inside exact.
  const Section other = of_points(chamfered);
  const auto lining = other.wall_points(layers, l0, reach);
  const Vec<2> middle(0.1785, 0.0215), inwards = Vec<2>(-1, 1).normalized();
  for (const double height : {0.5, 1.5, 3.0})
    EXPECT_NEAR(density(middle + height * l0 * inwards, lining, other, pi / 4) / n0, 1, height < 3 ? 0.03 : 1e-3);
}

TEST(Section, SurfaceIsTheWallWithTheInsideOnItsLeft) {
  const Section tank = circle(0.1, {0, 0.1});
  const SurfaceMesh mesh = tank.surface();
  double area = 0;
  ASSERT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.patches[0].name, "shell");
  for (const auto& face : mesh.patches[0].faces) {
    const auto &a = mesh.points[static_cast<std::size_t>(face[0])], &b = mesh.points[static_cast<std::size_t>(face[1])];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(area / (pi * 0.01), 1, 1e-4);
  EXPECT_NEAR(tank.area(), pi * 0.01, 1e-15);
  EXPECT_EQ(tank.description(), "x from -0.1 to 0.1 m, y from 0 to 0.2 m, and has no z");
}

}  // namespace
}  // namespace seiche::solver
