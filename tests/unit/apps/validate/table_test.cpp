#include "apps/validate/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/validate/known_misses.hpp"

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

TEST(Figure, MayMissItsTargetForAKnownReasonUpToABound) {
  const auto figure = [](double value) {
    return Figure{"", value, "%", at_most(1), KnownMiss{"too coarse", at_most(2)}};
  };
  EXPECT_TRUE(figure(1.5).is_known_miss() && !figure(1.5).met());
  EXPECT_EQ(verdict(figure(1.5)), "known miss by 0.5 %");
  EXPECT_FALSE(figure(0.5).is_known_miss());
  EXPECT_EQ(verdict(figure(0.5)), "met, no known miss any more");
  EXPECT_FALSE(figure(2.5).is_known_miss());
  EXPECT_EQ(verdict(figure(2.5)), "missed more than known, by 1.5 %");
  EXPECT_FALSE(figure(NAN).is_known_miss());
  EXPECT_EQ(verdict(figure(NAN)), "missed");
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
            "case,figure,value,unit,low,high,verdict,reason\n"
            "one,\"a\",1.5,%,,1,\"missed by 0.5 %\",\"\"\n"
            "one,\"b, c\",2,,,,\"-\",\"\"\n"
            "two,\"failed: it blew up\",,,,,,\n");
  EXPECT_EQ(count_text(outcomes), "2 figures: 0 met, 1 missed, 0 known misses, 1 without a target; 1 cases failed");
  EXPECT_NE(figures_text(outcomes[1]).find("it blew up"), std::string::npos);
}

TEST(Table, TellsTheReasonOfAKnownMiss) {
  const Outcome outcome{"one", {{{"a", 1.5, "%", at_most(1), KnownMiss{"too coarse", at_most(2)}}}, {}}, ""};
  EXPECT_TRUE(outcome.passed());
  EXPECT_NE(table_md({outcome}).find("| <= 1 % | known miss by 0.5 %: too coarse |\n"), std::string::npos);
  EXPECT_NE(table_csv({outcome}).find(",\"known miss by 0.5 %\",\"too coarse\"\n"), std::string::npos);
  EXPECT_NE(figures_text(outcome).find("known miss by 0.5 %: too coarse\n"), std::string::npos);
  EXPECT_EQ(count_text({outcome}), "1 figures: 0 met, 0 missed, 1 known miss, 0 without a target");
}

TEST(KnownMisses, AreMarkedByCaseAndFigureWhereThereIsATarget) {
  const std::vector<KnownMissOf> known{{"one", "a", {"why", at_most(2)}}};
  std::vector<Figure> figures{{"a", 1.5, "", at_most(1)}, {"b", 1.5, "", at_most(1)}, {"a", 1.5, "", {}}};
  mark_known_misses("two", figures, known);
  EXPECT_FALSE(figures[0].known);
  mark_known_misses("one", figures, known);
  EXPECT_TRUE(figures[0].is_known_miss());
  EXPECT_FALSE(figures[1].known);
  EXPECT_FALSE(figures[2].known) << "as a coarse run may have it";
}

}  // namespace
}  // namespace seiche::apps::validate
