#include "apps/scene/scene_text.hpp"

#include <gtest/gtest.h>

#include "apps/scene/options.hpp"
#include "apps/scene/scene_file.hpp"

namespace seiche::apps {
namespace {

const char* unusual =
    "preset = \"paper\"\n[fluid]\nviscosity = 1.1e-6\n[motion]\ntype = \"surge\"\namplitude = 0.1\nfrequency = "
    "0.333333333333\n"
    "[output]\nsize = \"800x600\"\nmovie = \"gif\"\n[look]\nrange = \"-1.5,2e3\"\nsurface = false\n";

TEST(SceneText, ReadsBackToTheSameScene) {
  const Scene scene = parse_scene(unusual, "x.toml", {});
  for (const std::string& text : {scene_text(scene), explained_scene_text(scene)}) {
    const Scene again = parse_scene(text, "x.toml", {});
    for (const Option& option : options())
      EXPECT_EQ(value_of(option, again), value_of(option, scene)) << dotted(option);
    EXPECT_EQ(scene_text(again), scene_text(scene));
  }
}

TEST(SceneText, ExplainsEachKeyOnItsLine) {
  const std::string text = explained_scene_text(Scene{});
  EXPECT_NE(text.find("\n[motion]\n"), std::string::npos);
  EXPECT_NE(text.find("\nlength = 0.6                     # box: along x; membrane: along z, 0: the run is 2-D; "
                      "cylinder: of its shell (a number from 0 to 1000 [m])\n"),
            std::string::npos);
}

TEST(SceneText, EscapesWhatTomlNeedsEscaped) {
  Scene scene;
  scene.parameters.motion.file = "a \"b\"\\c\td.csv";
  EXPECT_EQ(parse_scene(scene_text(scene), "x.toml", {}).parameters.motion.file, scene.parameters.motion.file);
}

TEST(SceneHash, IgnoresCommentsAndOrder) {
  const Scene a = parse_scene("# one\ngravity = 9.8\n[tank]\nheight = 0.5\nlength = 1\n", "x.toml", {});
  const Scene b = parse_scene("gravity = 9.80\n[tank]\nlength = 1.0 # metre\nheight = 0.5\n", "y.toml", {});
  EXPECT_EQ(scene_hash(a), scene_hash(b));
  EXPECT_EQ(scene_hash(a).size(), 16u);
}

TEST(SceneHash, TellsScenesApart) {
  EXPECT_NE(scene_hash(parse_scene("gravity = 9.8\n", "x.toml", {})),
            scene_hash(parse_scene("gravity = 9.9\n", "x.toml", {})));
}

}  // namespace
}  // namespace seiche::apps
