#include "render/curves/running_mean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace seiche::render;

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST(RunningMean, IsOfHalfAWindowToBothSides) {
  const Series mean = running_mean({{0, 1, 2, 3, 4}, {0, 10, 50, 30, 20}}, 2);
  EXPECT_EQ(mean.time, (std::vector<double>{0, 1, 2, 3, 4}));
  const std::vector<double> expected{5, 20, 30, 100.0 / 3, 25};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(mean.value[i], expected[i]) << i;
}

TEST(RunningMean, LeavesGapsOut) {
  const Series mean = running_mean({{0, 1, 2, 10}, {gap, 4, 8, gap}}, 2);
  EXPECT_DOUBLE_EQ(mean.value[0], 4);
  EXPECT_DOUBLE_EQ(mean.value[1], 6);
  EXPECT_DOUBLE_EQ(mean.value[2], 6);
  EXPECT_TRUE(std::isnan(mean.value[3]));
}

TEST(RunningMean, OfNothingIsNothing) { EXPECT_TRUE(running_mean({}, 1).value.empty()); }
