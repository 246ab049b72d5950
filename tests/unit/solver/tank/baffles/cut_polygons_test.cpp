#include "solver/tank/baffles/cut_polygons.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace seiche::solver {
namespace {

double area(const Polygons3& polygons) {
  double sum = 0;
  for (const Polygon3& p : polygons) {
    Vec<3> twice = Vec<3>::Zero();
    for (std::size_t k = 2; k < p.size(); ++k) twice += (p[k - 1] - p[0]).cross(p[k] - p[0]);
    sum += 0.5 * twice.norm();
  }
  return sum;
}

const Polygon3 square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(CutPolygons, InsideADistance) {
  const auto wall = [](const Vec<3>& r) { return r[0] - 0.3; };
  EXPECT_NEAR(area(inside(square, wall, 0, 0.05)), 0.3, 1e-9 * 0.05) << "a plane: exact but for the slack";
  const auto ball = [](const Vec<3>& r) { return r.norm() - 0.8; };
  EXPECT_NEAR(area(inside(square, ball, 0, 0.01)), 0.16 * std::numbers::pi, 1e-4);
  EXPECT_EQ(inside(
                square, [](const Vec<3>& r) { return r[0] - 0.99; }, 0.02, 0.05)
                .size(),
            1u)
      << "within the slack";
  EXPECT_TRUE(inside(
                  square, [](const Vec<3>& r) { return 0.1 - r[0] + 2; }, 0, 0.05)
                  .empty());
}

TEST(CutPolygons, OutsideASolid) {
  const auto plane = [](double x, double y, double offset) { return Face<3>{{x, y, 0}, offset}; };
  const auto pieces = outside(square, {plane(1, 0, 0.5), plane(-1, 0, -0.25), plane(0, 1, 2), plane(0, -1, -0.5)});
  EXPECT_NEAR(area(pieces), 1 - 0.25 * 0.5, 1e-12);
}

TEST(CutPolygons, JoinedSidesHaveEachOthersCorners) {
  Polygons3 pieces{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 0}, {2, 0, 0}, {2, 0.5, 0}, {1, 0.5, 0}}};
  join_sides(pieces);
  EXPECT_EQ(pieces[0].size(), 5u);
  EXPECT_EQ(pieces[1].size(), 4u);
}

}  // namespace
}  // namespace seiche::solver
