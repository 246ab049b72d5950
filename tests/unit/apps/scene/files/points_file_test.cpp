#include "apps/scene/files/points_file.hpp"

#include <gtest/gtest.h>

#include "apps/common/errors.hpp"
#include "tests/facts.hpp"

namespace seiche::apps {
namespace {

std::string error_of(const std::string& text, TankShape shape = TankShape::prism) {
  try {
    parse_points(text, "p.csv", shape);
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

TEST(PointsFile, HasItsColumnsInAnyOrderAndUnit) {
  const Points expected{{0, 0}, {1, 0}, {1, 2}};
  EXPECT_EQ(parse_points("x [m],y [m]\n0,0\n1,0\n1,2\n", "", TankShape::prism), expected);
  EXPECT_EQ(parse_points("y [cm],name,x [mm]\n0,a,0\n0,b,1000\n200,c,1000\n", "", TankShape::prism), expected);
  EXPECT_EQ(parse_points("r [m],z [m]\n0,0\n0,1\n2,1\n", "", TankShape::revolve), expected);
}

TEST(PointsFile, ErrorsNameThePlace) {
  EXPECT_TRUE(test::tells(error_of("x [m],r [m]\n0,0\n"), {"p.csv:1", "y", "x [m]", "prism"}));
  EXPECT_TRUE(test::tells(error_of("x [m],y [m]\n0,0\n", TankShape::revolve), {"p.csv:1", "z [m]", "r [m]"}));
  EXPECT_TRUE(test::tells(error_of("x [yd],y [m]\n0,0\n"), {"p.csv:1", "x [yd]", "[mm]"}));
  EXPECT_TRUE(test::tells(error_of("x [m],y [m]\n0,0\n1,one\n"), {"p.csv:3", "one"}));
  EXPECT_TRUE(test::tells(error_of("x [m],y [m]\n"), {"p.csv:1", "no points"}));
}

}  // namespace
}  // namespace seiche::apps
