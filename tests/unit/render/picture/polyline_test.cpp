#include "render/picture/polyline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace seiche::render;

namespace {

Series wave(int count, double interval) {
  Series series;
  for (int k = 0; k < count; ++k) {
    series.time.push_back(k * interval);
    series.value.push_back(std::sin(0.37 * k) + 0.001 * k);
  }
  return series;
}

double length(const Line& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return sum;
}

}  // namespace

TEST(Thinned, KeepsTheExtremesOfEachColumnAndBothEnds) {
  const Series all = wave(10000, 0.001);
  const double column = 0.02;
  const auto lines = thinned(all, 10, column);
  ASSERT_EQ(lines.size(), 1u);
  const Line& line = lines[0];
  EXPECT_LE(line.size(), 2u * 500u + 2u);
  EXPECT_EQ(line.front(), (Point{all.time.front(), all.value.front()}));
  EXPECT_EQ(line.back(), (Point{all.time.back(), all.value.back()}));
  EXPECT_TRUE(std::is_sorted(line.begin(), line.end(), [](const Point& a, const Point& b) { return a[0] < b[0]; }));
  for (long number = 0; number < 500; ++number) {
    double low = 9, high = -9, kept_low = 9, kept_high = -9;
    for (std::size_t i = 0; i < all.time.size(); ++i)
      if (static_cast<long>(all.time[i] / column) == number) {
        low = std::min(low, all.value[i]);
        high = std::max(high, all.value[i]);
      }
    for (const Point& point : line)
      if (static_cast<long>(point[0] / column) == number) {
        kept_low = std::min(kept_low, point[1]);
        kept_high = std::max(kept_high, point[1]);
      }
    EXPECT_EQ(kept_low, low) << number;
    EXPECT_EQ(kept_high, high) << number;
  }
}

TEST(Thinned, KeepsEveryPointOfASparseSeries) {
  const Series all = wave(50, 0.1);
  const auto lines = thinned(all, 100, 0.01);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].size(), 50u);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(lines[0][i], (Point{all.time[i], all.value[i]}));
}

TEST(Thinned, EndsWithTheReadingAtTheGivenTime) {
  const Series all = wave(1000, 0.001);
  for (const double until : {0.0, 0.02, 0.35, 0.999}) {
    const auto lines = thinned(all, until, 0.05);
    const auto row = static_cast<std::size_t>(std::lround(until / 0.001));
    EXPECT_EQ(lines.at(0).back(), (Point{all.time[row], all.value[row]})) << until;
  }
}

TEST(Thinned, BreaksWhereAValueIsNotFiniteAndBeginsAtZero) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Series series{{-1, 0, 1, 2, 3, 4, 5}, {9, 1, 2, nan, nan, 3, 4}};
  const auto lines = thinned(series, 10, 0.1);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], (Line{{0, 1}, {1, 2}}));
  EXPECT_EQ(lines[1], (Line{{4, 3}, {5, 4}}));
  EXPECT_TRUE(thinned({}, 1, 0.1).empty());
}

TEST(Dashed, CutsALineIntoDashesAndGaps) {
  const auto dashes = dashed({{0, 0}, {10, 0}}, 2, 1);
  ASSERT_EQ(dashes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(dashes[i].front()[0], 3.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(length(dashes[i]), i < 3 ? 2 : 1, 1e-9);
  }
}

TEST(Dashed, FollowsCornersAndShortPieces) {
  Line line;
  for (int k = 0; k <= 1000; ++k) line.push_back({std::cos(0.01 * k), std::sin(0.01 * k)});
  const auto dashes = dashed(line, 0.3, 0.2);
  double drawn = 0;
  for (const Line& one : dashes) drawn += length(one);
  EXPECT_NEAR(drawn / length(line), 0.6, 0.02);
  EXPECT_TRUE(dashed({}, 1, 1).empty());
  EXPECT_TRUE(dashed({{1, 1}}, 1, 1).empty());
}

TEST(Clipped, KeepsWhatLiesBetweenTwoHeights) {
  const Line line{{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 0}};
  const auto parts = clipped(line, {-1, 1});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0], (Line{{0, 0}, {0.5, 1}}));
  EXPECT_EQ(parts[1], (Line{{1.5, 1}, {2, 0}, {2.5, -1}}));
  EXPECT_EQ(parts[2], (Line{{3.5, -1}, {4, 0}}));
}

TEST(Clipped, ALineWithinStaysAsItIs) {
  const Line line{{0, -1}, {1, 1}, {2, 0}};
  EXPECT_EQ(clipped(line, {-1, 1}), (std::vector<Line>{line}));
}

TEST(Clipped, APieceMayPassThroughFromEndToEnd) {
  EXPECT_EQ(clipped({{0, -4}, {2, 4}}, {-2, 2}), (std::vector<Line>{{{0.5, -2}, {1.5, 2}}}));
  EXPECT_EQ(clipped({{0, 4}, {2, -4}}, {-2, 2}), (std::vector<Line>{{{0.5, 2}, {1.5, -2}}}));
  EXPECT_TRUE(clipped({{0, 3}, {2, 4}}, {-2, 2}).empty());
  EXPECT_TRUE(clipped({}, {-2, 2}).empty());
}
