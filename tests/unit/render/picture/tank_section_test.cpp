#include "render/picture/tank_section.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/render/synthetic.hpp"

namespace seiche::render {
namespace {

/// A tank of these loops, the inside on their left; a segment has ends of its own.
RunInfo tank_of(const std::vector<std::vector<std::array<double, 2>>>& loops) {
  RunInfo run;
  run.tank.patches.push_back({"wall", {}});
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int first = static_cast<int>(run.tank.points.size());
      for (const auto& [x, y] : {loop[k], loop[(k + 1) % loop.size()]}) run.tank.points.push_back({x, y, 0});
      run.tank.patches[0].faces.push_back({first, first + 1});
    }
  return run;
}

/// A square of side 2 with a hole of side 1 in its middle, and a plate from its floor.
RunInfo frame_with_a_plate() {
  return tank_of({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                  {{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}},
                  {{0, -1}, {0, -0.7}}});
}

double area(const TankSection& section, double top) {
  double sum = 0;
  for (const auto& q : section.quadrilaterals(top))
    for (std::size_t k = 0; k < 4; ++k) sum += 0.5 * (q[k][0] * q[(k + 1) % 4][1] - q[(k + 1) % 4][0] * q[k][1]);
  return sum;
}

TEST(TankSection, KnowsWhatIsInside) {
  const TankSection section(frame_with_a_plate());
  EXPECT_TRUE(section.holds(-0.7, 0));
  EXPECT_FALSE(section.holds(0, 0)) << "in the hole";
  EXPECT_FALSE(section.holds(-1.1, 0));
  EXPECT_TRUE(section.holds(0.1, -0.8));
  EXPECT_TRUE(section.holds(-0.1, -0.8)) << "on both sides of the plate";
  EXPECT_EQ(section.crossings(0), (std::vector<double>{-1, -0.5, 0.5, 1}));
}

TEST(TankSection, IsCutIntoQuadrilaterals) {
  const TankSection section(frame_with_a_plate());
  EXPECT_NEAR(area(section, 1), 4 - 1, 1e-12);
  EXPECT_NEAR(area(section, 0), 2 - 0.5, 1e-12);
  EXPECT_NEAR(area(TankSection(tank_of({{{0, 0}, {2, 0}, {1, 2}}})), 2), 2, 1e-12);
}

TEST(TankSection, OfAnOpenTankGoesOnAboveItsRim) {
  const RunInfo run = test::run_info({.length = 0.4, .height = 0.3, .closed = false});
  const TankSection section(run);
  EXPECT_TRUE(section.holds(0.2, 0.5));
  EXPECT_FALSE(section.holds(0.5, 0.5));
  EXPECT_NEAR(area(section, 0.5), 0.4 * 0.5, 1e-9);
  EXPECT_FALSE(TankSection(test::run_info({.length = 0.4, .height = 0.3})).holds(0.2, 0.5));
}

TEST(TankSection, TellsTheNormalOfTheNearestWall) {
  const TankSection section(frame_with_a_plate());
  EXPECT_LT((section.nearest_normal({-1.1, 0.2}) - Eigen::Vector2d(-1, 0)).norm(), 1e-12);
  EXPECT_LT((section.nearest_normal({0, -1.3}) - Eigen::Vector2d(0, -1)).norm(), 1e-12);
  EXPECT_LT((section.nearest_normal({0.4, 0.1}) - Eigen::Vector2d(-1, 0)).norm(), 1e-12) << "into the hole";
}

}  // namespace
}  // namespace seiche::render
