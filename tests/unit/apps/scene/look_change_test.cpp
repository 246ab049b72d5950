#include "apps/scene/look_change.hpp"

#include <gtest/gtest.h>

#include "apps/scene/scene_file.hpp"
#include "render/curves.hpp"
#include "render/picture.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

std::string refusal(Scene scene, const std::string& set) {
  try {
    change_look(scene, {parse_set(set)});
  } catch (const BadScene& error) {
    return error.what();
  }
  return "taken";
}

TEST(LookChange, ChangesHowARunLooks) {
  Scene scene = parse_scene("", "x.toml", {});
  change_look(scene, {parse_set("look.colour_map=turbo"),
                      {"--size 640x480", "output.size", "640x480"},
                      parse_set("look.walls=false"),
                      parse_set("look.curves=eta_left")});
  EXPECT_EQ(scene.look.colour_map, render::ColourMapName::turbo);
  EXPECT_EQ(scene.look.width, 640);
  EXPECT_FALSE(scene.look.show_walls);
  EXPECT_EQ(render::text_of(scene.look.curves), "eta_left");
}

TEST(LookChange, ARangeGoesWithItsQuantity) {
  const auto range_after = [](const std::vector<Override>& overrides) {
    Scene scene = parse_scene("look.range = \"0,2500\"\n", "x.toml", {});
    change_look(scene, overrides);
    return render::text_of(scene.look.range);
  };
  EXPECT_EQ(range_after({}), "0,2500");
  EXPECT_EQ(range_after({parse_set("look.quantity=pressure")}), "0,2500");
  EXPECT_EQ(range_after({parse_set("look.quantity=speed")}), "scene");
  EXPECT_EQ(range_after({parse_set("look.range=0,2"), parse_set("look.quantity=speed")}), "0,2");
}

TEST(LookChange, RefusesWhatTheRunHasSettled) {
  const Scene scene = parse_scene("", "x.toml", {});
  for (const auto& [key, value] : {std::pair<std::string, std::string>{"motion.amplitude", "1"},
                                   {"output.frame_rate", "10"},
                                   {"sensors.gauge", "[{name = \"a\"}]"}}) {
    const std::string set = key + "=" + value;
    EXPECT_TRUE(test::tells(refusal(scene, set), {"--set " + set, key, "[look]", "output.size"}));
  }
}

TEST(LookChange, RefusesWhatNobodyKnowsAsARunDoes) {
  const Scene scene = parse_scene("", "x.toml", {});
  EXPECT_TRUE(test::tells(refusal(scene, "look.colour_mop=turbo"),
                          {"--set", "look.colour_mop=turbo", "'look.colour_mop'", "'look.colour_map'?"}));
  EXPECT_TRUE(test::tells(refusal(scene, "look.colour_map=red"), {"look.colour_map=red", "viridis", "cividis"}));
  EXPECT_TRUE(test::tells(refusal(scene, "look.curves=eta_lft"), {"look.curves=eta_lft", "'eta_left'?"}));
}

TEST(LookChange, ReadsNewReferencesFromTheScenesFolder) {
  const test::Scratch scratch;
  test::write_text(scratch / "theory.csv", "t,eta_left\n0,0\n1,0.1\n");
  Scene scene = parse_scene("", (scratch / "x.toml").string(), {});
  change_look(scene, {parse_set("look.reference=[{of = \"eta_left\", file = \"theory.csv\"}]")});
  ASSERT_EQ(scene.look.references.size(), 1u);
  EXPECT_EQ(scene.look.references[0].series.value, (std::vector<double>{0, 0.1}));
}

}  // namespace
}  // namespace seiche::apps
