#include "solver/modes/outline.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "solver/errors.hpp"
#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

using test::box;

double area(const Loop& loop) {
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) twice += turn({0, 0}, loop[k].at, loop[(k + 1) % loop.size()].at);
  return 0.5 * twice;
}

double area(const Outline& body) {
  double sum = area(body.outer);
  for (const Loop& hole : body.holes) sum += area(hole);
  return sum * body.unit * body.unit;
}

double surface(const Outline& body) {
  double sum = 0;
  for (std::size_t k = 0; k < body.outer.size(); ++k)
    if (body.outer[k].surface) sum += (body.outer[(k + 1) % body.outer.size()].at - body.outer[k].at).norm();
  return sum * body.unit;
}

std::string refusal(double level, const Polygons& section) {
  try {
    liquid_below(level, section);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Outline, OfABoxInTheMiddleOfItsHeight) {
  const auto bodies = liquid_below(0.2, box(0.5, 0.3));
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_NEAR(area(bodies[0]), 0.1, 1e-8);
  EXPECT_NEAR(surface(bodies[0]), 0.5, 1e-7);
}

TEST(Outline, FullToTheRim) { EXPECT_NEAR(area(liquid_below(0.3, box(0.5, 0.3))[0]), 0.15, 1e-8); }

TEST(Outline, TwoChambersBelowTheTopOfAWall) {
  const auto bodies = liquid_below(0.08, test::baffled(0.02));
  ASSERT_EQ(bodies.size(), 2u);
  for (const Outline& body : bodies) EXPECT_NEAR(area(body), 0.24 * 0.08, 1e-8);
}

TEST(Outline, AWallUpToTheLevelParts) {
  for (const double thickness : {0.02, 0.0}) EXPECT_EQ(liquid_below(0.1, test::baffled(thickness)).size(), 2u);
}

TEST(Outline, APlateFromTheRoofLeavesOneBodyWithTwoSurfaces) {
  for (const double thickness : {0.02, 0.0}) {
    Polygons section = test::baffled(thickness);
    for (Vec<2>& at : section[0]) at = Vec<2>(0.5, 0.3) - at;
    const auto bodies = liquid_below(0.25, section);
    ASSERT_EQ(bodies.size(), 1u);
    EXPECT_NEAR(area(bodies[0]), 0.5 * 0.25 - thickness * 0.05, 1e-8);
    EXPECT_NEAR(surface(bodies[0]), 0.5 - thickness, 1e-7);
  }
}

TEST(Outline, AHoleIsCutOrBelowOrAbove) {
  Polygons section = box(0.5, 0.3);
  section.push_back({{0.2, 0.1}, {0.2, 0.2}, {0.3, 0.2}, {0.3, 0.1}});
  EXPECT_NEAR(area(liquid_below(0.25, section)[0]), 0.125 - 0.01, 1e-8);
  EXPECT_EQ(liquid_below(0.25, section)[0].holes.size(), 1u);
  EXPECT_NEAR(area(liquid_below(0.15, section)[0]), 0.075 - 0.005, 1e-8);
  EXPECT_NEAR(surface(liquid_below(0.15, section)[0]), 0.4, 1e-7);
  EXPECT_NEAR(area(liquid_below(0.05, section)[0]), 0.025, 1e-8);
}

TEST(Outline, ATankWithinAHoleIsABodyOfItsOwn) {
  Polygons section = box(0.5, 0.3);
  section.push_back({{0.1, 0.1}, {0.1, 0.2}, {0.4, 0.2}, {0.4, 0.1}});
  section.push_back({{0.2, 0.12}, {0.3, 0.12}, {0.3, 0.18}, {0.2, 0.18}});
  EXPECT_EQ(liquid_below(0.15, section).size(), 2u);
  // Where it is full, it has no free surface.
  EXPECT_EQ(liquid_below(0.25, section).size(), 1u);
}

TEST(Outline, ATopOfTheWallThatTouchesTheLevelIsNoSurface) {
  // A gable at x = 0.1 comes up to the level under a roof; the shaft beside it is open.
  const Polygons section{{{0, 0}, {0.5, 0}, {0.5, 0.3}, {0.3, 0.3}, {0.3, 0.1}, {0.1, 0.2}, {0, 0.1}}};
  const auto bodies = liquid_below(0.2, section);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_NEAR(surface(bodies[0]), 0.2, 1e-7);
}

TEST(Outline, SaysWhatIsWrongWithTheLevel) {
  EXPECT_NE(refusal(0, box(0.5, 0.3)).find("leaves no liquid"), std::string::npos);
  EXPECT_NE(refusal(-1, box(0.5, 0.3)).find("fill it higher"), std::string::npos);
  EXPECT_NE(refusal(0.31, box(0.5, 0.3)).find("above the tank's top at 0.3 m"), std::string::npos);
  EXPECT_NE(refusal(0.5, test::circle(0.25)).find("no free surface"), std::string::npos);
  EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN(), box(0.5, 0.3)).find("level"), std::string::npos);
}

TEST(Outline, SaysWhatIsWrongWithTheSection) {
  EXPECT_NE(refusal(0.1, {}).find("no size"), std::string::npos);
  EXPECT_NE(refusal(0.1, {{{0, 0}, {1, std::numeric_limits<double>::infinity()}, {0, 1}}}).find("give numbers"),
            std::string::npos);
  // Clockwise.
  EXPECT_NE(refusal(0.1, {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}), "accepted");
}

}  // namespace
}  // namespace seiche::solver::modes
