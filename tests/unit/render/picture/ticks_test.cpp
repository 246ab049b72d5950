#include "render/picture/ticks.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace seiche::render;

TEST(Ticks, RoundedHoldsTheRange) {
  for (const Range range : {Range{0, 0}, Range{5, 5}, Range{-13, 977}, Range{1.234e5, 1.235e5}, Range{-2e-3, 1e-3}}) {
    const Range round = rounded(range);
    EXPECT_LE(round.low, range.low);
    EXPECT_GE(round.high, range.high);
    EXPECT_LT(round.low, round.high);
    const double slack = std::max(range.high - range.low, 1.0) * 0.7;
    EXPECT_LT(round.high - round.low, range.high - range.low + slack + 1) << "not much wider than needed";
  }
}

TEST(Ticks, AreRoundAndWithinTheRange) {
  const auto expect = [](Range range, const std::vector<double>& values) {
    const auto ticks = round_ticks(range).values;
    ASSERT_EQ(ticks.size(), values.size()) << range.low << " to " << range.high;
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(ticks[i], values[i], 1e-9);
  };
  expect({0, 3000}, {0, 500, 1000, 1500, 2000, 2500, 3000});
  expect({0, 1500}, {0, 250, 500, 750, 1000, 1250, 1500});
  expect({-130, 370}, {-100, 0, 100, 200, 300});
  expect({0, 1}, {0, 0.2, 0.4, 0.6, 0.8, 1});
}

TEST(Ticks, LabelsHaveTheDigitsThatTheStepNeeds) {
  EXPECT_EQ(tick_label(500, 500), "500");
  EXPECT_EQ(tick_label(0, 0.25), "0.00");
  EXPECT_EQ(tick_label(0.75, 0.25), "0.75");
  EXPECT_EQ(tick_label(7.5, 2.5), "7.5");
  EXPECT_EQ(tick_label(-20, 10), "\u221220");
  EXPECT_EQ(tick_label(2e6, 1e6), "2e+06");
  EXPECT_EQ(tick_label(1.0005e6, 500), "1.0005e+06");
  EXPECT_EQ(tick_label(0.12005, 5e-5), "0.12005");
  EXPECT_EQ(tick_label(-7.5e-7, 2.5e-7), "\u22127.5e-07");
  EXPECT_EQ(tick_label(0, 2.5e-7), "0");
}

TEST(Ticks, LabelsDifferWhereverTheAxisIs) {
  for (const double middle : {0.0, 0.12, 1.0, 1962.0, 3.5e6})
    for (const double span : {1e-8, 3e-7, 1e-5, 2e-4, 0.03, 4.0, 5e5}) {
      if (span < 1e-9 * middle) continue;  // beyond what a sensor resolves
      const Ticks ticks = round_ticks({middle, middle + span});
      std::set<std::string> labels;
      for (const double value : ticks.values) labels.insert(tick_label(value, ticks.step));
      EXPECT_EQ(labels.size(), ticks.values.size()) << middle << " and on by " << span;
    }
}

TEST(Ruler, IsRoundAndNotLonger) {
  EXPECT_DOUBLE_EQ(round_below(0.12), 0.1);
  EXPECT_DOUBLE_EQ(round_below(0.1), 0.1);
  EXPECT_DOUBLE_EQ(round_below(0.49), 0.2);
  EXPECT_DOUBLE_EQ(round_below(7), 5);
}
