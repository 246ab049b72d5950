#include "render/panels/deviation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace seiche::render;

TEST(Deviation, IsTheRootMeanSquareAtTheReferencesTimes) {
  const Series series{{0, 0.5, 1, 1.5, 2}, {1, 9, 2, 9, 5}}, reference{{0, 1, 2}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(deviation(series, reference, 2), std::sqrt((0 + 1 + 16) / 3.0));
  EXPECT_DOUBLE_EQ(deviation(series, reference, 1), std::sqrt(0.5));
}

TEST(Deviation, GoesStraightBetweenSamples) { EXPECT_DOUBLE_EQ(deviation({{0, 2}, {0, 4}}, {{0.5}, {0}}, 2), 1); }

TEST(Deviation, CountsCommonTimesOnly) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(deviation({{1, 2}, {3, 3}}, {{0, 1, 1.5, 2, 3}, {0, 1, gap, 1, 0}}, 3), 2);
  EXPECT_TRUE(std::isnan(deviation({{1, 2}, {3, 3}}, {{5}, {0}}, 9)));
  EXPECT_TRUE(std::isnan(deviation({}, {{5}, {0}}, 9)));
}

TEST(Deviation, IsToldInTheSensorsUnit) {
  const seiche::Column elevation{"e", "m", "e", seiche::ColumnKind::elevation}, pressure{"p", "Pa", "p"};
  EXPECT_EQ(deviation_text(0.00412, elevation, "VOF"), "4.1 mm RMS off VOF");
  EXPECT_EQ(deviation_text(1234.6, pressure, "theory"), "1235 Pa RMS off theory");
  EXPECT_EQ(deviation_text(0.5, {"v", "m^2", "v", seiche::ColumnKind::volume}, "theory"), "0.5 m\u00b2 RMS off theory");
  EXPECT_EQ(deviation_text(0.00412, elevation, ""), "4.1 mm RMS") << "where there is no room for more";
  EXPECT_EQ(deviation_text(std::nan(""), elevation, "VOF"), "");
}
