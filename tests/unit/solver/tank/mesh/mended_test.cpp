#include "solver/tank/mesh/mended.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/facts.hpp"
#include "tests/unit/solver/tank/mesh/meshes.hpp"

namespace seiche::solver {
namespace {

constexpr double l0 = 0.01;

std::string error_of(const SurfaceMesh& mesh) {
  try {
    mended(mesh, l0);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "no error";
}

double volume(const Triangles& mesh) {
  double sum = 0;
  for (int t = 0; t < mesh.count(); ++t) sum += mesh.centre(t).dot(mesh.area(t)) / 3;
  return sum;
}

/// A box of 0.1 m whose top has a square hole in its middle; `cut` moves a corner of the hole outwards.
SurfaceMesh box_with_hole(double side, double cut = 0) {
  SurfaceMesh mesh = test::box({0.1, 0.1, 0.1});
  auto& faces = mesh.patches[0].faces;
  faces.erase(faces.begin() + 6, faces.begin() + 8);  // y = 0.1
  const double low = 0.05 - side / 2, high = 0.05 + side / 2;
  mesh.points.push_back({low - cut, 0.1, low - cut});
  mesh.points.push_back({high, 0.1, low});
  mesh.points.push_back({high, 0.1, high});
  mesh.points.push_back({low, 0.1, high});
  const int outer[] = {2, 3, 7, 6};
  for (int k = 0; k < 4; ++k) test::add_square(mesh, 0, outer[k], outer[(k + 1) % 4], 8 + (k + 1) % 4, 8 + k);
  return mesh;
}

TEST(Mended, TurnsTrianglesOutwards) {
  for (const auto turn_over : {+[](SurfaceMesh&) {}, +[](SurfaceMesh& mesh) { test::turn_some(mesh); },
                               +[](SurfaceMesh& mesh) {
                                 for (auto& face : mesh.patches[0].faces) std::swap(face[1], face[2]);
                               }}) {
    SurfaceMesh mesh = test::box({0.1, 0.2, 0.3});
    turn_over(mesh);
    const Mended result = mended(mesh, l0);
    EXPECT_NEAR(volume(result.mesh), 0.006, 1e-15);
    EXPECT_TRUE(result.simple);
  }
  SurfaceMesh mesh = test::box({1, 1, 1});
  std::swap(mesh.patches[0].faces[4][0], mesh.patches[0].faces[4][1]);
  EXPECT_EQ(mended(mesh, l0).faults.turned, 1);
}

TEST(Mended, BoxesInBoxesAreSolidAndLiquidByTurns) {
  SurfaceMesh mesh = test::box({1, 1, 1});
  test::add_box(mesh, "solid", {0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  test::add_box(mesh, "cavity", {0.4, 0.4, 0.4}, {0.6, 0.6, 0.6});
  test::add_box(mesh, "other tank", {1.2, 0, 0}, {1.7, 0.5, 0.5});
  EXPECT_NEAR(volume(mended(mesh, l0).mesh), 1 - 0.216 + 0.008 + 0.125, 1e-12);
}

TEST(Mended, ClosesHolesUpToASpacing) {
  const Mended result = mended(box_with_hole(0.5 * l0), l0);
  EXPECT_EQ(result.faults.holes.count, 1);
  EXPECT_EQ(result.faults.holes.open_sides, 4);
  EXPECT_NEAR(result.faults.holes.widest, 0.5 * l0, 0.1 * l0);
  EXPECT_NEAR(volume(result.mesh), 1e-3, 1e-15);
  EXPECT_TRUE(result.simple);
  EXPECT_EQ(error_of(box_with_hole(0.95 * l0)), "no error");
  EXPECT_EQ(error_of(box_with_hole(0.2 * l0, 0.03)), "no error") << "a long slit";
}

TEST(Mended, RefusesWiderHolesWithTheirPlace) {
  EXPECT_TRUE(seiche::test::tells(error_of(box_with_hole(2 * l0)),
                                  {"a hole", "0.01 m", "0.02 m wide", "(0.05, 0.1, 0.05) m", "close"}));
  EXPECT_TRUE(seiche::test::tells(error_of(box_with_hole(1.1 * l0)), {"a hole", "0.011 m wide"}));
  SurfaceMesh open = test::box({0.1, 0.1, 0.1});
  open.patches[0].faces.resize(10);
  EXPECT_TRUE(seiche::test::tells(error_of(open), {"a hole", "0.1 m wide", "(0.05, 0.05, 0.1) m"}));
  open.patches[0].faces.erase(open.patches[0].faces.begin(), open.patches[0].faces.begin() + 2);
  test::add_box(open, "far", {1, 1, 1}, {1.2, 1.2, 1.2});
  open.patches[1].faces.resize(10);
  EXPECT_TRUE(seiche::test::tells(error_of(open), {"2 holes", "0.2 m wide", "(1.1, 1.1, 1.2) m"}));
}

TEST(Mended, JoinsPointsThatAreNearlyInOnePlace) {
  SurfaceMesh apart;
  apart.patches.push_back({"wall", {}});
  const SurfaceMesh box = test::box({0.1, 0.1, 0.1});
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-2e-9, 2e-9);
  for (const auto& face : box.patches[0].faces) {
    std::vector<int> corners;
    for (const int at : face) {
      corners.push_back(static_cast<int>(apart.points.size()));
      const auto& r = box.points[at];
      apart.points.push_back({r[0] + off(random), r[1] + off(random), r[2] + off(random)});
    }
    apart.patches[0].faces.push_back(corners);
  }
  const Mended result = mended(apart, l0);
  EXPECT_EQ(result.faults.holes.open_sides, 0);
  EXPECT_NEAR(volume(result.mesh), 1e-3, 1e-9);
}

TEST(Mended, CutsSidesAtPointsOfOthersAndTakesOutSlivers) {
  // The top's two triangles are four about its middle on one side of a diagonal that the other side has whole.
  for (const bool sliver : {false, true}) {
    SurfaceMesh mesh = test::box({0.1, 0.1, 0.1});
    auto& faces = mesh.patches[0].faces;
    const auto half = faces[6];
    faces.erase(faces.begin() + 6);
    const int middle = static_cast<int>(mesh.points.size());
    mesh.points.push_back({0.05, 0.1, 0.05});
    faces.push_back({half[0], half[1], middle});
    faces.push_back({half[1], half[2], middle});
    if (sliver) faces.push_back({half[2], half[0], middle});
    const Mended result = mended(mesh, l0);
    EXPECT_EQ(result.faults.slivers, 1);
    EXPECT_EQ(result.faults.holes.open_sides, 0);
    EXPECT_EQ(result.mesh.count(), 14);
    EXPECT_NEAR(volume(result.mesh), 1e-3, 1e-15);
  }
}

TEST(Mended, LeavesOutDoubles) {
  SurfaceMesh mesh = test::box({0.1, 0.1, 0.1});
  mesh.patches[0].faces.push_back(mesh.patches[0].faces[3]);
  mesh.patches[0].faces.push_back({0, 0, 1});
  const Mended result = mended(mesh, l0);
  EXPECT_EQ(result.faults.left_out.doubles, 1);
  EXPECT_EQ(result.faults.left_out.degenerate, 1);
  EXPECT_EQ(result.mesh.count(), 12);
}

TEST(Mended, RefusesWhatIsNoTank) {
  EXPECT_TRUE(seiche::test::tells(error_of({{{0, 0, 0}, {1, 0, 0}}, {{"a", {{0, 1, 1}}}}}), {"no triangle"}));
  SurfaceMesh sheet = test::box({0.1, 0.1, 0.1});
  sheet.patches[0].faces.push_back({0, 2, 7});
  sheet.patches[0].faces.push_back({0, 7, 5});
  EXPECT_TRUE(seiche::test::tells(error_of(sheet), {"3 triangles", "(0, 0, 0) m", "sheet", "thickness"}));
  SurfaceMesh crossing = test::box({0.1, 0.1, 0.1});
  test::add_box(crossing, "b", {0.05, 0.05, 0.05}, {0.15, 0.15, 0.15});
  EXPECT_TRUE(seiche::test::tells(error_of(crossing), {"passes through itself", "0.05", "join"}));
  // A spike of one box that ends just behind a side of another does no harm, a longer one does.
  for (const double depth : {0.05 * l0, 0.5 * l0}) {
    SurfaceMesh poked = test::box({0.1, 0.1, 0.1});
    const int first = static_cast<int>(poked.points.size());
    for (const auto& r : {Vec<3>(0.1 - depth, 0.043, 0.052), Vec<3>(0.13, 0.02, 0.02), Vec<3>(0.13, 0.08, 0.03),
                          Vec<3>(0.13, 0.04, 0.09)})
      poked.points.push_back({r[0], r[1], r[2]});
    poked.patches.push_back({"spike", {}});
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      poked.patches[1].faces.push_back({first + a, first + b, first + c});
    if (depth > 0.1 * l0)
      EXPECT_TRUE(seiche::test::tells(error_of(poked), {"passes through itself", "(0.1, "}));
    else
      EXPECT_FALSE(mended(poked, l0).simple);
  }
  SurfaceMesh moebius;
  moebius.patches.push_back({"strip", {}});
  for (int k = 0; k < 10; ++k) {
    const double angle = 2 * std::numbers::pi * k / 10;
    for (const double side : {-0.3, 0.3}) {
      const double out = 1 + side * std::cos(angle / 2);
      moebius.points.push_back({out * std::cos(angle), side * std::sin(angle / 2), out * std::sin(angle)});
    }
  }
  for (int k = 0; k < 9; ++k) test::add_square(moebius, 0, 2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2);
  test::add_square(moebius, 0, 18, 19, 0, 1);
  EXPECT_TRUE(seiche::test::tells(error_of(moebius), {"one side only", "near"}));
}

TEST(Mended, BoxesThatTouchAlongASideAreTwoTanks) {
  SurfaceMesh mesh = test::box({0.1, 0.1, 0.1});
  test::add_box(mesh, "b", {0.1, 0.1, 0}, {0.2, 0.2, 0.1});
  const Mended result = mended(mesh, l0);
  EXPECT_FALSE(result.simple);
  EXPECT_NEAR(volume(result.mesh), 2e-3, 1e-12);
}

}  // namespace
}  // namespace seiche::solver
