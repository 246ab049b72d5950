#include "solver/pressure/turn_along_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// Of radius 25 l0, its middle at (0, 25 l0).
std::shared_ptr<const Shape<3>> sphere() {
  Parameters p;
  p.tank = {.shape = TankShape::sphere, .length = 0, .height = 0, .radius = 25 * l0};
  return make_shape<3>(p);
}

const Vec<3> middle(0, 25 * l0, 0);

TEST(TurnAlongWall, IsTheCentripetalAccelerationInASphere) {
  const Vec<3> out = Vec<3>(1, -2, 3).normalized(), along = out.cross(Vec<3>::UnitX()).normalized();
  for (const double from_middle : {24.5 * l0, 22 * l0}) {
    const Vec<3> turn = turn_along_wall<3>(*sphere(), middle + from_middle * out, 1.5 * along, l0);
    const Vec<3> exact = -1.5 * 1.5 / from_middle * out;
    EXPECT_LT((turn - exact).norm(), 1e-3 * exact.norm());
  }
}

TEST(TurnAlongWall, IsOfSecondOrderInTheSpacing) {
  const Vec<3> at = middle + 20 * l0 * Vec<3>::UnitX();
  const auto error = [&](double h) { return turn_along_wall<3>(*sphere(), at, Vec<3>::UnitY(), h)[0] + 1 / (20 * l0); };
  EXPECT_NEAR(std::log2(error(4 * l0) / error(2 * l0)), 2, 0.05);
}

TEST(TurnAlongWall, IsZeroOfLiquidThatRestsOrMeetsTheWallSquarely) {
  const Vec<3> at = middle + 24 * l0 * Vec<3>::UnitX();
  EXPECT_TRUE(turn_along_wall<3>(*sphere(), at, Vec<3>::Zero(), l0).isZero());
  EXPECT_LT(turn_along_wall<3>(*sphere(), at, Vec<3>::UnitX(), l0).norm(), 1e-12);
}

TEST(TurnAlongWall, IsZeroAlongFlatWallsAndInTheirCorners) {
  const auto box = make_shape<2>(test::small_tank<2>());
  EXPECT_TRUE(turn_along_wall<2>(*box, Vec<2>(0.1, 0.3 * l0), Vec<2>(2, 0.1), l0).isZero());
  EXPECT_TRUE(turn_along_wall<2>(*box, Vec<2>(0.3 * l0, 0.3 * l0), Vec<2>(2, -2), l0).isZero());
}

}  // namespace
}  // namespace seiche::solver
