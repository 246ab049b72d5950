#include "render/liquid/arrows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/liquid/arrow.hpp"
#include "render/picture/range.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

Frame fluid(const std::vector<Float3>& positions) {
  Frame frame;
  frame.position = positions;
  frame.kind.assign(positions.size(), Kind::fluid);
  return frame;
}

}  // namespace

TEST(Arrows, AreBornNearestToTheMiddleOfEachSquare) {
  const Frame frame = fluid({{0.2f, 0.5f, 0}, {0.45f, 0.5f, 0}, {1.5f, 0.6f, 0}, {1.5f, 0.4f, 0}});
  EXPECT_EQ(arrow_bearers(frame, 1), (std::vector<std::size_t>{1, 3})) << "as near to its middle as 2 is, or nearer";
}

TEST(Arrows, AreNotBornInCornersOrByWalls) {
  Frame frame = fluid({{0.1f, 0.1f, 0}, {1.5f, 0.5f, 0}, {std::nanf(""), 0.5f, 0}});
  frame.kind[1] = Kind::wall;
  EXPECT_TRUE(arrow_bearers(frame, 1).empty());
}

TEST(Arrows, AreAsManyAtEverySpacing) {
  const auto bearers = [](double spacing) {
    return arrow_bearers(*test::lattice({.spacing = spacing}, 0), 0.04).size();
  };
  EXPECT_EQ(bearers(0.01), 15u * 5u);
  EXPECT_EQ(bearers(0.005), bearers(0.01));
}

TEST(Arrows, ScaleIsTheScenesOrTheRangeOfTheSpeed) {
  const RunInfo run = test::run_info({});
  Look look;
  const ArrowScale scene = arrow_scale(run, look);
  EXPECT_EQ(scene.greatest, scene_range(run, Quantity::speed).high);
  EXPECT_NEAR(scene.reference, 0.2, 1e-9);
  look.range = {RangeSource::given, {0, 3000}};
  EXPECT_EQ(arrow_scale(run, look).greatest, scene.greatest) << "a range of pressures";
  look.quantity = Quantity::speed;
  look.range = {RangeSource::given, {0, 0.1}};
  EXPECT_NEAR(arrow_scale(run, look).length, 10 * scene.greatest * scene.length, 1e-9);
}

TEST(Arrows, ShrinkWhereFewerThanEightWouldStandSideBySide) {
  EXPECT_EQ(arrow_font(600, 20), 20);
  EXPECT_DOUBLE_EQ(arrow_font(330, 20), 15);
  EXPECT_EQ(arrow_font(100, 20), 12) << "too small to see";
}

TEST(Arrows, ReachFromTailToTipInTheirDirection) {
  for (const double length : {0.3, 1.0, 5.0}) {
    const ArrowShape arrow = placed(arrow_shape(length, 1), {1, 2}, {0, 1});
    const auto above = [](const Point& a, const Point& b) { return a[1] < b[1]; };
    EXPECT_NEAR((*std::max_element(arrow.head.begin(), arrow.head.end(), above))[1], 2 + length / 2, 1e-12);
    EXPECT_NEAR((*std::min_element(arrow.shaft.begin(), arrow.shaft.end(), above))[1], 2 - length / 2, 1e-12);
  }
}
