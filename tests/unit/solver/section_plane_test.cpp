#include "solver/section_plane.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/facts.hpp"

namespace seiche {
namespace {

TEST(SectionPlane, IsReadFromText) {
  EXPECT_EQ(parse_section("x=0").axis, Axis::x);
  EXPECT_EQ(parse_section("z = -0.25").axis, Axis::z);
  EXPECT_EQ(parse_section("z = -0.25").at, -0.25);
  for (const char* bad : {"", "x", "x=", "w=0", "x=1m", "x=nan", "x0"})
    EXPECT_THROW(parse_section(bad), BadParameters) << bad;
  try {
    parse_section("y=0.1");
    ADD_FAILURE();
  } catch (const BadParameters& error) {
    EXPECT_TRUE(test::tells(error.what(), {"y=0.1", "gravity", "z=0"}));
  }
  EXPECT_EQ(parse_section(text_of({Axis::x, 0.1})), (SectionPlane{Axis::x, 0.1}));
}

}  // namespace
}  // namespace seiche
