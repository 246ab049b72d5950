#include "solver/tank/measures.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

std::string refusal_of(const Parameters::Tank& tank) {
  try {
    check_measures(tank);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "taken";
}

TEST(Measures, ATankHasThoseOfItsShape) {
  Parameters::Tank ball = initial_tank(TankShape::sphere);
  EXPECT_TRUE(test::tells(refusal_of(ball), {"tank.radius", "missing", "sphere"}));
  ball.radius = 1;
  EXPECT_EQ(refusal_of(ball), "taken");
  ball.width = 2;
  EXPECT_TRUE(test::tells(refusal_of(ball), {"tank.width", "sphere", "tank.radius"}));
  ball.width = 0;
  ball.closed = false;
  EXPECT_TRUE(test::tells(refusal_of(ball), {"tank.closed", "box"}));
  EXPECT_EQ(refusal_of(initial_tank(TankShape::box)), "taken") << "has measures to start from";
}

TEST(Measures, ASectionCutsABody) {
  Parameters::Tank tank = initial_tank(TankShape::membrane);
  tank.breadth = tank.height = 1;
  tank.section = SectionPlane{Axis::x, 0};
  EXPECT_TRUE(test::tells(refusal_of(tank), {"tank.section", "x=0", "tank.length"}));
  tank.length = 1;
  EXPECT_EQ(refusal_of(tank), "taken");
}

}  // namespace
}  // namespace seiche::solver
