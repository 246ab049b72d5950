#include "apps/validate/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace seiche::apps::validate {
namespace {

TEST(Figure, IsHeldAgainstItsTarget) {
  const auto verdict_of = [](double value, std::optional<Target> target) { return verdict({"", value, "%", target}); };
  EXPECT_EQ(verdict_of(1, at_most(1)), "met");
  EXPECT_EQ(verdict_of(1.25, at_most(1)), "missed by 0.25 %");
  EXPECT_EQ(verdict_of(0.5, at_least(1)), "missed by 0.5 %");
  EXPECT_EQ(verdict_of(-0.6, within(0.5)), "missed by 0.1 %");
  EXPECT_EQ(verdict_of(0.6, within(0.5)), "missed by 0.1 %");
  EXPECT_EQ(verdict_of(NAN, within(0.5)), "missed");
  EXPECT_EQ(verdict_of(7, {}), "-");
}

TEST(Figure, IsWrittenWithItsUnit) {
  const auto target_of = [](Target target) { return target_text({"", 0, "s", target}); };
  EXPECT_EQ(target_of(at_most(2)), "<= 2 s");
  EXPECT_EQ(target_of(at_least(10)), ">= 10 s");
  EXPECT_EQ(target_of(within(0.5)), "+-0.5 s");
  EXPECT_EQ(target_of(at_most(0)), "<= 0 s");
  EXPECT_EQ(target_of({0.9, 1.1}), "0.9 to 1.1 s");
  EXPECT_EQ(target_text({"", 0, "s", {}}), "-");
  EXPECT_EQ(value_text({"", 0.123456, "", {}}), "0.123");
  EXPECT_EQ(value_text({"", 1200, "s", {}}), "1200 s");
}

TEST(Table, HasARowForEachFigureAndEachFailure) {
  const std::vector<Outcome> outcomes{{"one", {{{"a", 1.5, "%", at_most(1)}, {"b, c", 2, "", {}}}, {}}, ""},
                                      {"two", {}, "it blew up"}};
  EXPECT_EQ(table_md(outcomes),
            "| case | figure | value | target | |\n|---|---|---|---|---|\n"
            "| one | a | 1.5 % | <= 1 % | missed by 0.5 % |\n"
            "|  | b, c | 2 | - | - |\n"
            "| two | failed: it blew up | | | |\n");
  EXPECT_EQ(table_csv(outcomes),
            "case,figure,value,unit,low,high,verdict\n"
            "one,\"a\",1.5,%,,1,missed by 0.5 %\n"
            "one,\"b, c\",2,,,,-\n"
            "two,\"failed: it blew up\",,,,,\n");
  EXPECT_EQ(count_text(outcomes), "2 figures: 0 met, 1 missed, 1 without a target; 1 cases failed");
  EXPECT_NE(figures_text(outcomes[1]).find("it blew up"), std::string::npos);
}

}  // namespace
}  // namespace seiche::apps::validate
