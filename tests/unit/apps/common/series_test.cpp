#include "apps/common/series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

TEST(Series, IsLinearBetweenSamplesAndConstantBeyond) {
  const Series s{{0, 1, 3}, {0, 2, -2}};
  EXPECT_DOUBLE_EQ(s.at(0.25), 0.5);
  EXPECT_DOUBLE_EQ(s.at(2), 0);
  EXPECT_DOUBLE_EQ(s.at(1), 2);
  EXPECT_DOUBLE_EQ(s.at(-1), 0);
  EXPECT_DOUBLE_EQ(s.at(9), -2);
  EXPECT_EQ(s.between(1, 3).t, (std::vector<double>{1, 3}));
  EXPECT_DOUBLE_EQ(median_interval(s.t), 2);
  EXPECT_DOUBLE_EQ(rms({3, 4}), std::sqrt(12.5));
}

TEST(ReadSeries, FindsColumnsByName) {
  const test::Scratch scratch;
  test::write_text(scratch / "a.csv", "t,eta [m],p\r\n0,0.5,1\r\n0.1,-2e-3,3\r\n");
  const Series s = read_series(scratch / "a.csv", "t", "eta [m]");
  EXPECT_EQ(s.t, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(s.y, (std::vector<double>{0.5, -0.002}));
  EXPECT_EQ(read_series(scratch / "a.csv", "t", "p").y, (std::vector<double>{1, 3}));
}

TEST(ReadSeries, SaysWhatIsMissing) {
  const test::Scratch scratch;
  const auto complaint = [&](const std::string& text) {
    test::write_text(scratch / "a.csv", text);
    try {
      read_series(scratch / "a.csv", "t", "p");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_TRUE(test::tells(complaint("t,q\n0,1\n"), {"a.csv:1: ", "'p'"}));
  EXPECT_TRUE(test::tells(complaint("t,p\n0,x\n"), {"a.csv:2: ", "p = 'x'", "-1.5e-3"}));
  EXPECT_TRUE(test::tells(complaint("t,p\n0\n"), {"a.csv:2: ", "1", "2"}));
  EXPECT_TRUE(test::tells(complaint(""), {"a.csv:1: ", "empty"}));
}

}  // namespace
}  // namespace seiche::apps
