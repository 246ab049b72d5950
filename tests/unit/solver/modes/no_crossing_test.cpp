#include "solver/modes/no_crossing.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

TEST(NoCrossing, TouchingIsNone) {
  for (const double thickness : {0.02, 0.0})
    EXPECT_NO_THROW(check_no_crossing(liquid_below(0.2, test::baffled(thickness))[0]));
}

TEST(NoCrossing, OfASectionThatCrossesItself) {
  const auto outline = liquid_below(0.9, {{{0, 0}, {0.6, 0.5}, {0.4, 0.5}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_THROW(check_no_crossing(outline[0]), BadParameters);
}

TEST(NoCrossing, OfAHoleThatCrossesTheWall) {
  Polygons section = test::box(1, 1);
  section.push_back({{0.9, 0.4}, {0.9, 0.6}, {1.1, 0.6}, {1.1, 0.4}});
  const auto outline = liquid_below(0.9, section);
  EXPECT_THROW(check_no_crossing(outline[0]), BadParameters);
}

}  // namespace
}  // namespace seiche::solver::modes
