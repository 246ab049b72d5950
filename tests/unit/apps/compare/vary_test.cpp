#include "apps/compare/vary.hpp"

#include <gtest/gtest.h>

#include "tests/facts.hpp"

namespace seiche::apps::compare {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    parse_vary(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of_all(const std::vector<std::string>& varied, const std::vector<Override>& fixed = {}) {
  std::vector<Vary> all;
  for (const std::string& each : varied) all.push_back(parse_vary(each));
  try {
    combinations(all, fixed);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

const Option* key(const char* section, const char* name) { return find_option(section, name); }

TEST(ParseVary, TakesAKeyAndItsValues) {
  const Vary vary = parse_vary("method.kernel=KF1,KF3");
  EXPECT_EQ(vary.option, key("method", "kernel"));
  ASSERT_EQ(vary.values.size(), 2u);
  EXPECT_EQ(vary.values[1].key, "method.kernel");
  EXPECT_EQ(vary.values[1].value, "KF3");
  EXPECT_EQ(vary.values[1].origin, "--vary method.kernel=KF3");
  EXPECT_EQ(parse_vary("preset=paper").values.size(), 1u);
}

TEST(ParseVary, RefusesWhatIsNoKeyOrNoneToVary) {
  EXPECT_TRUE(test::tells(refusal_of("method.kernl=KF1"),
                          {"--vary", "method.kernl=KF1", "'method.kernl'", "'method.kernel'?"}));
  EXPECT_TRUE(test::tells(refusal_of("sensors.gauge=1"), {"--vary", "sensors.gauge=1"}));
  EXPECT_TRUE(
      test::tells(refusal_of("look.range=frame"), {"--vary", "look.range=frame", "look.range", "look.range", "--set"}));
}

TEST(ParseVary, RefusesMissingValues) {
  for (const std::string text : {"method.kernel", "method.kernel=", "method.kernel=KF1,", "method.kernel=,KF1"})
    EXPECT_TRUE(test::tells(refusal_of(text), {"--vary " + text + ": ", "KEY=VALUE,VALUE", "method.kernel=KF1,KF3"}));
}

TEST(Combinations, AreAllOfThemTheLastKeyChangingFastest) {
  const auto all = combinations({parse_vary("method.kernel=KF1,KF3"), parse_vary("particles.spacing=0.02,0.01")}, {});
  std::string values;
  for (const auto& each : all) values += each.at(0).value + " " + each.at(1).value + ";";
  EXPECT_EQ(values, "KF1 0.02;KF1 0.01;KF3 0.02;KF3 0.01;");
}

TEST(Combinations, RefuseMoreThanAPictureHasRoomFor) {
  EXPECT_TRUE(
      test::tells(refusal_of_all({"method.kernel=KF1,KF2,KF3,KF4,KF5", "particles.spacing=0.02,0.01"}), {"10", "9"}));
  EXPECT_EQ(refusal_of_all({"method.kernel=KF1,KF2,KF3", "particles.spacing=0.04,0.02,0.01"}), "");
}

TEST(Combinations, RefuseAKeyThatIsSetTwice) {
  EXPECT_TRUE(test::tells(refusal_of_all({"method.kernel=KF1", "method.kernel=KF3"}), {"method.kernel", "--vary"}));
  EXPECT_TRUE(test::tells(refusal_of_all({"method.kernel=KF1"}, {{"--kernel KF2", "method.kernel", "KF2"}}),
                          {"--kernel", "KF2", "method.kernel"}));
}

}  // namespace
}  // namespace seiche::apps::compare
