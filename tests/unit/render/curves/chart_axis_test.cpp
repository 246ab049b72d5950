#include "render/curves/chart_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seiche::render {
namespace {

ChartAxis axis_of(const std::vector<double>& values, Scale scale) {
  return chart_axis({{"", {}, values}}, &Curve::y, scale);
}

TEST(ChartAxis, ALinearOneTakesInZeroAndEndsAtRoundNumbers) {
  const ChartAxis axis = axis_of({3, 9.7}, Scale::linear);
  EXPECT_EQ(axis.range.low, 0);
  EXPECT_DOUBLE_EQ(axis.range.high, 10);
  EXPECT_EQ(axis.labels.front(), "0");
  EXPECT_EQ(axis.labels.back(), "10");
  EXPECT_EQ(axis.labels.size(), axis.places.size());
}

TEST(ChartAxis, DecadesGoFromAOneTwoOrFiveToAnother) {
  const ChartAxis axis = axis_of({0.3, 7}, Scale::decades);
  EXPECT_EQ(axis.labels, (std::vector<std::string>{"0.2", "0.5", "1", "2", "5", "10"}));
  EXPECT_NEAR(axis.range.low, std::log10(0.2), 1e-12);
  EXPECT_NEAR(axis.range.high, 1, 1e-12);
  for (std::size_t k = 0; k < axis.places.size(); ++k)
    EXPECT_NEAR(std::pow(10, axis.places[k]), std::stod(axis.labels[k]), 1e-9);
  EXPECT_EQ(axis_of({1000, 50000}, Scale::decades).labels.front(), "1000");
  EXPECT_EQ(axis_of({1000, 50000}, Scale::decades).labels.back(), "50000");
}

TEST(ChartAxis, DecadesHaveAWidthAlsoForOneValueOrNone) {
  EXPECT_EQ(axis_of({2}, Scale::decades).labels, (std::vector<std::string>{"2", "5"}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(axis_of({0, -1, nan}, Scale::decades).labels, (std::vector<std::string>{"1", "2", "5", "10"}));
}

}  // namespace
}  // namespace seiche::render
