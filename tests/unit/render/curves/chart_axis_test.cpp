#include "render/curves/chart_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seiche::render {
namespace {

Axis axis_over(const std::vector<double>& values, Scale scale) {
  return chart_axis({{"", {}, values}}, &Curve::y, scale);
}

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> all;
  for (const Tick& tick : axis.ticks) all.push_back(tick.label);
  return all;
}

TEST(ChartAxis, ALinearOneTakesInZeroAndEndsAtRoundNumbers) {
  const Axis axis = axis_over({3, 9.7}, Scale::linear);
  EXPECT_EQ(axis.range.low, 0);
  EXPECT_DOUBLE_EQ(axis.range.high, 10);
  EXPECT_EQ(axis.ticks.front().label, "0");
  EXPECT_EQ(axis.ticks.back().label, "10");
}

TEST(ChartAxis, DecadesGoFromAOneTwoOrFiveToAnother) {
  const Axis axis = axis_over({0.3, 7}, Scale::decades);
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0.2", "0.5", "1", "2", "5", "10"}));
  EXPECT_NEAR(axis.range.low, std::log10(0.2), 1e-12);
  EXPECT_NEAR(axis.range.high, 1, 1e-12);
  for (const Tick& tick : axis.ticks) EXPECT_NEAR(std::pow(10, tick.position), std::stod(tick.label), 1e-9);
  EXPECT_EQ(axis_over({1000, 50000}, Scale::decades).ticks.front().label, "1000");
  EXPECT_EQ(axis_over({1000, 50000}, Scale::decades).ticks.back().label, "50000");
}

TEST(ChartAxis, DecadesHaveAWidthAlsoForOneValueOrNone) {
  EXPECT_EQ(labels(axis_over({2}, Scale::decades)), (std::vector<std::string>{"2", "5"}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(labels(axis_over({0, -1, nan}, Scale::decades)), (std::vector<std::string>{"1", "2", "5", "10"}));
}

}  // namespace
}  // namespace seiche::render
