#include "render/picture/range.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

TEST(Range, ReadsWhereItComesFrom) {
  EXPECT_EQ(parse_range("scene").source, RangeSource::scene);
  EXPECT_EQ(parse_range("frame").source, RangeSource::frame);
  EXPECT_EQ(parse_range("run").source, RangeSource::run);
  for (const char* text : {"scene", "frame", "run", "-100,3000", "0.1,1e+20"})
    EXPECT_EQ(text_of(parse_range(text)), text);
}

TEST(Range, ReadsTwoNumbers) {
  const auto range = parse_range(" -250.5, 3e3");
  EXPECT_EQ(range.source, RangeSource::given);
  EXPECT_DOUBLE_EQ(range.given.low, -250.5);
  EXPECT_DOUBLE_EQ(range.given.high, 3000);
}

TEST(Range, RefusesAnythingElse) {
  for (const char* text : {"", "auto", "1", "1,", ",1", "1,2,3", "2,1", "1,1", "a,b", "0,inf", "nan,1", "0,1 Pa"})
    EXPECT_THROW(parse_range(text), std::invalid_argument) << text;
}

TEST(Range, OfTheSceneEndsAtARoundTick) {
  auto run = test::run_info({});  // 1.5 rho g H = 2943 Pa
  EXPECT_DOUBLE_EQ(scene_range(run).low, 0);
  EXPECT_DOUBLE_EQ(scene_range(run).high, 3000);
  run.depth = 0.02;  // 294.3 Pa
  EXPECT_DOUBLE_EQ(scene_range(run).high, 300);
  run.depth = 1.7;  // 25015.5 Pa
  EXPECT_DOUBLE_EQ(scene_range(run).high, 30000);
}

TEST(Range, OfTheSceneSuitsTheQuantity) {
  RunInfo run;
  run.density = 1000;
  run.gravity = run.pull = 9.81;
  run.depth = 0.2;  // sqrt(g H) = 1.4 m/s
  EXPECT_DOUBLE_EQ(scene_range(run, Quantity::speed).low, 0);
  EXPECT_NEAR(scene_range(run, Quantity::speed).high, 0.8, 1e-9);
  EXPECT_DOUBLE_EQ(scene_range(run, Quantity::number_density).low + scene_range(run, Quantity::number_density).high, 2);
  EXPECT_NEAR(scene_range(run, Quantity::vorticity).low, -8, 1e-9) << "-sqrt(g/H) = -7.0 1/s, and turns both ways";
  EXPECT_NEAR(scene_range(run, Quantity::vorticity).high, 8, 1e-9);
  EXPECT_DOUBLE_EQ(scene_range(run, Quantity::free_surface).high, 1);
  EXPECT_DOUBLE_EQ(scene_range(run, Quantity::kind).high, 2);
}

TEST(Range, IsFixedUnlessItComesFromFrames) {
  const RunInfo run;
  Look look;
  const auto fixed = [&](const char* range) {
    look.range = parse_range(range);
    return fixed_range(run, look);
  };
  EXPECT_TRUE(fixed("scene"));
  EXPECT_DOUBLE_EQ(fixed("-1,2")->high, 2);
  EXPECT_FALSE(fixed("frame"));
  EXPECT_FALSE(fixed("run"));
  look.quantity = Quantity::kind;
  for (const char* range : {"scene", "-1,2", "frame", "run"}) EXPECT_DOUBLE_EQ(fixed(range)->high, 2) << range;
}

TEST(Range, OfTheFluidLeavesWallsAndNanOut) {
  Frame frame;
  frame.position.resize(4);
  frame.pressure = {-3, 7, 500, std::numeric_limits<float>::quiet_NaN()};
  frame.kind = {Kind::fluid, Kind::fluid, Kind::wall, Kind::fluid};
  EXPECT_DOUBLE_EQ(fluid_range(frame).low, -3);
  EXPECT_DOUBLE_EQ(fluid_range(frame).high, 7);
  EXPECT_DOUBLE_EQ(fluid_range(Frame{}).high, 0);
}
