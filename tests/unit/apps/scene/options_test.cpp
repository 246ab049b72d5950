#include "apps/scene/options.hpp"

#include <gtest/gtest.h>

#include <set>

namespace seiche::apps {
namespace {

TEST(Options, EachKeyOccursOnce) {
  std::set<std::string> seen;
  for (const Option& option : options()) EXPECT_TRUE(seen.insert(dotted(option)).second) << dotted(option);
}

TEST(Options, SectionsStayTogether) {
  const std::vector<std::string> all = sections();
  EXPECT_EQ(all.size(), std::set<std::string>(all.begin(), all.end()).size());
}

// Another value than the default that the key takes.
Value other_value(const Option& option) {
  const Value now = value_of(option, Scene{});
  if (const bool* truth = std::get_if<bool>(&now)) return !*truth;
  if (const auto* range = std::get_if<Range>(&option.rule)) {
    return std::holds_alternative<double>(now) ? Value(range->high) : Value(static_cast<std::int64_t>(range->high));
  }
  if (const auto* choices = std::get_if<Choices>(&option.rule)) return std::string(choices->back());
  if (const auto* rule = std::get_if<OneOr>(&option.rule)) return rule->range.high;
  if (std::holds_alternative<Pairs>(option.rule)) return Points{{0, 0}, {1, 0}, {0, 1}};
  if (option.key == "section") return std::string("x=0.5");
  if (option.key == "size") return std::string("800x600");
  return std::string(option.key == "curves" ? "0" : "0,1");
}

TEST(Options, EachKeySetsItsOwnMemberAndNoOther) {
  for (const Option& option : options()) {
    Scene scene;
    assign(option, scene, other_value(option));
    for (const Option& other : options()) {
      const Value& expected = &other == &option ? other_value(option) : value_of(other, Scene{});
      EXPECT_EQ(value_of(other, scene), expected) << dotted(option) << " set, " << dotted(other) << " read";
    }
  }
}

TEST(Options, DefaultsObeyTheirOwnRules) {
  for (const Option& option : options()) {
    Scene scene;
    EXPECT_EQ(assign(option, scene, value_of(option, Scene{})), std::nullopt) << dotted(option);
  }
}

TEST(Options, EachTakesEveryChoiceThatItNames) {
  for (const Option& option : options()) {
    const auto* choices = std::get_if<Choices>(&option.rule);
    if (!choices) continue;
    for (const std::string_view choice : *choices) {
      Scene scene;
      EXPECT_EQ(assign(option, scene, std::string(choice)), std::nullopt) << dotted(option);
      EXPECT_EQ(value_of(option, scene), Value(std::string(choice)));
    }
  }
}

TEST(Options, ARefusedValueLeavesTheSceneAsItWas) {
  Scene scene;
  const Option& depth = *find_option("fluid", "depth");
  EXPECT_TRUE(assign(depth, scene, -1.0));
  EXPECT_EQ(scene.parameters.fluid.depth, Parameters{}.fluid.depth);
}

TEST(Options, AnOpenLowerEndIsRefusedAndAClosedOneTaken) {
  Scene scene;
  EXPECT_TRUE(assign(*find_option("fluid", "depth"), scene, 0.0));
  EXPECT_FALSE(assign(*find_option("fluid", "viscosity"), scene, 0.0));
}

TEST(Options, AWholeNumberServesAsARealOneButNotTheOtherWayRound) {
  Scene scene;
  EXPECT_FALSE(assign(*find_option("time", "end"), scene, std::int64_t{2}));
  EXPECT_EQ(scene.parameters.time.end, 2.0);
  EXPECT_TRUE(assign(*find_option("pressure", "max_iterations"), scene, 2.0));
}

TEST(Options, SizeIsWrittenWidthByHeight) {
  Scene scene;
  const Option& size = *find_option("output", "size");
  EXPECT_FALSE(assign(size, scene, std::string("1920x1080")));
  EXPECT_EQ(scene.look.width, 1920);
  EXPECT_EQ(scene.look.height, 1080);
  for (const char* bad : {"", "1920", "1920x", "x1080", "1920x1080x2", "-1920x1080", "1e3x1080", "8x8", "99999x1080"}) {
    EXPECT_TRUE(assign(size, scene, std::string(bad))) << bad;
  }
}

}  // namespace
}  // namespace seiche::apps
