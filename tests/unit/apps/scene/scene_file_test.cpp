#include "apps/scene/scene_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/scene/options.hpp"
#include "render/picture.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/errors_of.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;
using test::write_text;

TEST(SceneFile, AnEmptyOneIsTheDefaultScene) {
  const Scene scene = parse_scene("", "some/where/pan2008.toml", {});
  EXPECT_EQ(scene.name, "pan2008");
  EXPECT_EQ(scene.file, "some/where/pan2008.toml");
  EXPECT_EQ(scene.parameters.preset, Parameters{}.preset);
  EXPECT_EQ(scene.output.frame_rate, Output{}.frame_rate);
}

TEST(SceneFile, KeysReachTheirMembers) {
  const Scene scene =
      parse_scene("gravity = 1.6\n[tank]\nlength = 1\nclosed = false\n[look]\nwalls = false\n", "x.toml", {});
  EXPECT_EQ(scene.parameters.gravity.size(), 1.6);
  EXPECT_EQ(scene.parameters.tank.length, 1.0);
  EXPECT_FALSE(scene.parameters.tank.closed);
  EXPECT_FALSE(scene.look.show_walls);
}

TEST(SceneFile, ThePresetComesFirstWhereverItIsSet) {
  const Parameters p = parse_scene("preset = \"paper\"\n[method]\nkernel = \"KF5\"\n", "x.toml", {}).parameters;
  EXPECT_EQ(p.preset, Preset::paper);
  EXPECT_EQ(p.method.source, SourceTerm::density);
  EXPECT_EQ(p.method.kernel, "KF5");
  EXPECT_EQ(p.pressure.solver, SolverName::iccg);
  EXPECT_EQ(parse_scene("preset = \"paper\"\n[pressure]\nsolver = \"amg\"\n", "x.toml", {}).parameters.pressure.solver,
            SolverName::amg);

  const Override preset{"--set preset=paper", "preset", "paper"};
  EXPECT_EQ(parse_scene("[method]\nsource = \"mixed\"\n", "x.toml", {preset}).parameters.method.source,
            SourceTerm::mixed);
}

TEST(SceneFile, TheLastOverrideWins) {
  const Override first{"--spacing 0.01", "particles.spacing", "0.01"},
      second{"--spacing 0.02", "particles.spacing", "0.02"};
  const Scene scene = parse_scene("[particles]\nspacing = 0.005\n", "x.toml", {first, second});
  EXPECT_EQ(scene.parameters.particles.spacing, 0.02);
}

TEST(SceneFile, AnUnknownKeyNamesItsPlaceAndTheNearestOne) {
  EXPECT_TRUE(test::tells(errors_of("\n[motion]\n  amplitde = 0.01\n"),
                          {"x.toml:3:3", "[motion]", "amplitde", "'amplitude'?"}));
  EXPECT_TRUE(test::tells(errors_of("gravty = 1\n"), {"x.toml:1:1", "'gravity'?"}));
}

TEST(SceneFile, AKeyInTheWrongSectionIsSentToItsOwn) {
  EXPECT_TRUE(test::tells(errors_of("depth = 0.1\n"), {"x.toml:1:1", "[fluid]"}));
  EXPECT_TRUE(
      test::tells(errors_of("[tank]\ngravity = 1\n"), {"x.toml:2:1", "[tank]", "gravity", "'gravity'", "[section]"}));
}

TEST(SceneFile, AKeyLikeNoOtherGetsTheWholeList) {
  EXPECT_TRUE(test::tells(errors_of("[motion]\nxyz = 1\n"), {"x.toml:2:1", "[motion]", "xyz", "pivot_x", "pivot_y"}));
}

TEST(SceneFile, AnUnknownSectionNamesTheNearestOne) {
  EXPECT_TRUE(test::tells(errors_of("[moton]\n"), {"x.toml:1:2", "[moton]", "[motion]?"}));
}

TEST(SceneFile, ASectionIsNoKey) {
  EXPECT_TRUE(test::tells(errors_of("tank = 3\n"), {"x.toml:1:1", "'tank'", "[tank]"}));
}

TEST(SceneFile, AWrongTypeSaysWhatIsExpected) {
  EXPECT_TRUE(test::tells(errors_of("[fluid]\ndepth = \"deep\"\n"),
                          {"x.toml:2:9", "[fluid]", "depth", "'deep'", "0", "1000", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("[tank]\nclosed = 1\n"), {"x.toml:2:10", "[tank]", "closed", "1"}));
  EXPECT_TRUE(test::tells(errors_of("[pressure]\nmax_iterations = 1.5\n"),
                          {"x.toml:2:18", "[pressure]", "max_iterations", "1.5", "1", "1000000"}));
  EXPECT_TRUE(
      test::tells(errors_of("[fluid]\ndepth = [1, 2]\n"), {"x.toml:2:9", "[fluid]", "depth", "0", "1000", "[m]"}));
  const std::string twice = errors_of("[tank]\nshape = \"ball\"\n[fluid]\ndepth = -1\n");
  EXPECT_EQ(std::count(twice.begin(), twice.end(), '\n'), 1) << "each is told once: " << twice;
}

TEST(SceneFile, AValueOutOfRangeOrNotFiniteIsRefused) {
  EXPECT_TRUE(test::tells(errors_of("[motion]\nfrequency = -1\n"),
                          {"x.toml:2:13", "[motion]", "frequency", "-1", "0", "100", "[Hz]"}));
  EXPECT_TRUE(test::tells(errors_of("gravity = nan\n"), {"x.toml:1:11", "0", "100", "[m/s^2]"}));
  EXPECT_TRUE(test::tells(errors_of("gravity = inf\n"), {"x.toml:1:11", "0", "100", "[m/s^2]"}));
}

TEST(SceneFile, AWrongChoiceListsTheRightOnes) {
  EXPECT_TRUE(test::tells(errors_of("[pressure]\nsolver = \"icg\"\n"),
                          {"x.toml:2:10", "[pressure]", "solver", "'icg'", "'iccg'?"}));
}

TEST(SceneFile, BadTomlNamesItsPlace) { EXPECT_EQ(errors_of("[fluid]\ndepth = = 1\n").substr(0, 12), "x.toml:2:9: "); }

TEST(SceneFile, EveryMistakeIsToldInTheOrderOfTheFileThenOfTheFlags) {
  EXPECT_TRUE(
      test::tells(errors_of("gravty = 1\n[fluid]\ndepth = -1\ndensty = 1\n", {parse_set("tank.lenght=1")}),
                  {"x.toml:1:1", "'gravity'?", "x.toml:3:9", "[fluid]", "depth", "-1", "0", "1000", "[m]", "x.toml:4:1",
                   "[fluid]", "densty", "'density'?", "--set", "tank.lenght=1", "'tank.lenght'", "'tank.length'?"}));
}

TEST(SceneFile, KeysThatDontFitTogetherAreRefused) {
  EXPECT_TRUE(test::tells(errors_of("[fluid]\ndepth = 0.5\n"), {"x.toml", "fluid.depth", "0.5", "tank.height", "0.4"}));
}

TEST(SceneFile, AStepOfItsOwnMustFallOnFramesAndOnTheEnd) {
  const auto errors = [](const char* step, const char* end) {
    return errors_of(fmt::format("[time]\nstep = {}\nend = {}\n", step, end));  // 50 frames a second
  };
  EXPECT_EQ(errors("5e-4", "10"), "no error");
  EXPECT_EQ(errors("0", "10.00031"), "no error");
  EXPECT_TRUE(
      test::tells(errors("0.0003", "3"), {"x.toml", "1/output.frame_rate", "0.02", "66.667", "time.step", "0.0003"}));
  EXPECT_TRUE(
      test::tells(errors("0.0005", "3.0003"), {"x.toml", "time.end", "3.0003", "6000.600", "time.step", "0.0005"}));
  EXPECT_TRUE(test::tells(errors("-1", "1"), {"x.toml:2:8", "[time]", "step", "-1", "0", "1", "[s]"}));
}

TEST(SceneFile, AMissingFileIsNamed) { EXPECT_THROW(read_scene("no/such/file.toml", {}), BadScene); }

TEST(SceneFile, AnEmptyFileIsReadAndAFolderIsNot) {
  const Scratch scratch;
  write_text(scratch / "empty.toml", "");
  EXPECT_EQ(read_scene(scratch / "empty.toml", {}).name, "empty");
  EXPECT_THROW(read_scene(scratch.folder(), {}), BadScene);
}

TEST(Overrides, NameTheFlagAtFault) {
  EXPECT_TRUE(test::tells(errors_of("", {parse_set("amplitde=3")}),
                          {"--set", "amplitde=3", "'amplitde'", "'motion.amplitude'?"}));
  EXPECT_TRUE(test::tells(errors_of("", {parse_set("depth=3")}), {"--set", "depth=3", "'depth'", "'fluid.depth'?"}));
  EXPECT_TRUE(test::tells(errors_of("", {{"--spacing big", "particles.spacing", "big"}}),
                          {"--spacing", "[particles]", "spacing", "'big'", "0", "10", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("", {parse_set("time.end=inf")}),
                          {"--set", "time.end=inf", "[time]", "end", "0", "100000", "[s]"}));
}

TEST(Overrides, TextNeedsNoQuotes) {
  const Scene scene = parse_scene("", "x.toml",
                                  {parse_set("method.kernel=KF1"), parse_set("look.range=-100,3000"),
                                   parse_set("output.vtu=false"), parse_set("pressure.tolerance=1e-6")});
  EXPECT_EQ(scene.parameters.method.kernel, "KF1");
  EXPECT_EQ(render::text_of(scene.look.range), "-100,3000");
  EXPECT_FALSE(scene.writes(OutputKind::vtu));
  EXPECT_EQ(scene.parameters.pressure.tolerance, 1e-6);
}

}  // namespace
}  // namespace seiche::apps
