#include "apps/scene/scene_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/scene/options.hpp"
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
  EXPECT_EQ(scene.parameters.gravity, 1.6);
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
  EXPECT_EQ(errors_of("\n[motion]\n  amplitde = 0.01\n"),
            "x.toml:3:3: unknown key [motion] amplitde; did you mean 'amplitude'?");
  EXPECT_EQ(errors_of("gravty = 1\n"), "x.toml:1:1: unknown key gravty; did you mean 'gravity'?");
}

TEST(SceneFile, AKeyInTheWrongSectionIsSentToItsOwn) {
  EXPECT_EQ(errors_of("depth = 0.1\n"), "x.toml:1:1: unknown key depth; it belongs under [fluid]");
  EXPECT_EQ(errors_of("[tank]\ngravity = 1\n"),
            "x.toml:2:1: unknown key [tank] gravity; 'gravity' stands above the first [section]");
}

TEST(SceneFile, AKeyLikeNoOtherGetsTheWholeList) {
  EXPECT_EQ(errors_of("[motion]\nxyz = 1\n"),
            "x.toml:2:1: unknown key [motion] xyz; expected one of type, amplitude, frequency, phase, ramp, "
            "file, pivot_x, pivot_y, start, "
            "harmonic");
}

TEST(SceneFile, AnUnknownSectionNamesTheNearestOne) {
  EXPECT_EQ(errors_of("[moton]\n"), "x.toml:1:2: [moton] is no section of a scene; did you mean [motion]?");
}

TEST(SceneFile, ASectionIsNoKey) {
  EXPECT_EQ(errors_of("tank = 3\n"),
            "x.toml:1:1: 'tank' is a section: write [tank] on a line of its own, above its keys");
}

TEST(SceneFile, AWrongTypeSaysWhatIsExpected) {
  EXPECT_EQ(errors_of("[fluid]\ndepth = \"deep\"\n"),
            "x.toml:2:9: [fluid] depth = 'deep' is no number; expected a number above 0, up to 1000 [m]");
  EXPECT_EQ(errors_of("[tank]\nclosed = 1\n"), "x.toml:2:10: [tank] closed = 1 is neither; expected true or false");
  EXPECT_EQ(
      errors_of("[pressure]\nmax_iterations = 1.5\n"),
      "x.toml:2:18: [pressure] max_iterations = 1.5 is no whole number; expected a whole number from 1 to 1000000");
  EXPECT_EQ(errors_of("[fluid]\ndepth = [1, 2]\n"),
            "x.toml:2:1: [fluid] depth takes one value; expected a number above 0, up to 1000 [m]");
}

TEST(SceneFile, AValueOutOfRangeOrNotFiniteIsRefused) {
  EXPECT_EQ(errors_of("[motion]\nfrequency = -1\n"),
            "x.toml:2:13: [motion] frequency = -1 is out of range; expected a number from 0 to 100 [Hz]");
  EXPECT_EQ(errors_of("gravity = nan\n"),
            "x.toml:1:11: gravity = nan is not finite; expected a number above 0, up to 100 [m/s^2]");
  EXPECT_EQ(errors_of("gravity = inf\n"),
            "x.toml:1:11: gravity = inf is not finite; expected a number above 0, up to 100 [m/s^2]");
}

TEST(SceneFile, AWrongChoiceListsTheRightOnes) {
  EXPECT_EQ(errors_of("[pressure]\nsolver = \"icg\"\n"),
            "x.toml:2:10: [pressure] solver = 'icg' is none of its choices; expected one of amg, iccg, sor, cholmod; "
            "did you mean 'iccg'?");
}

TEST(SceneFile, BadTomlNamesItsPlace) { EXPECT_EQ(errors_of("[fluid]\ndepth = = 1\n").substr(0, 12), "x.toml:2:9: "); }

TEST(SceneFile, EveryMistakeIsToldInTheOrderOfTheFileThenOfTheFlags) {
  EXPECT_EQ(errors_of("gravty = 1\n[fluid]\ndepth = -1\ndensty = 1\n", {parse_set("tank.lenght=1")}),
            "x.toml:1:1: unknown key gravty; did you mean 'gravity'?\n"
            "x.toml:3:9: [fluid] depth = -1 is out of range; expected a number above 0, up to 1000 [m]\n"
            "x.toml:4:1: unknown key [fluid] densty; did you mean 'density'?\n"
            "--set tank.lenght=1: unknown key 'tank.lenght'; did you mean 'tank.length'?");
}

TEST(SceneFile, KeysThatDontFitTogetherAreRefused) {
  EXPECT_EQ(errors_of("[fluid]\ndepth = 0.5\n"), "x.toml: fluid.depth = 0.5 m is more than tank.height = 0.4 m");
}

TEST(SceneFile, AStepOfItsOwnMustFallOnFramesAndOnTheEnd) {
  const auto errors = [](const char* step, const char* end) {
    return errors_of(fmt::format("[time]\nstep = {}\nend = {}\n", step, end));  // 50 frames a second
  };
  EXPECT_EQ(errors("5e-4", "10"), "no error");
  EXPECT_EQ(errors("0", "10.00031"), "no error");
  EXPECT_EQ(errors("0.0003", "3"),
            "x.toml: 1/output.frame_rate = 0.02 s is 66.667 steps of time.step = 0.0003 s; it must be a whole number "
            "of them");
  EXPECT_EQ(errors("0.0005", "3.0003"),
            "x.toml: time.end = 3.0003 s is 6000.600 steps of time.step = 0.0005 s; it must be a whole number of them");
  EXPECT_EQ(errors("-1", "1"), "x.toml:2:8: [time] step = -1 is out of range; expected a number from 0 to 1 [s]");
}

TEST(SceneFile, AMissingFileIsNamed) { EXPECT_THROW(read_scene("no/such/file.toml", {}), BadScene); }

TEST(SceneFile, AnEmptyFileIsReadAndAFolderIsNot) {
  const Scratch scratch;
  write_text(scratch / "empty.toml", "");
  EXPECT_EQ(read_scene(scratch / "empty.toml", {}).name, "empty");
  EXPECT_THROW(read_scene(scratch.folder(), {}), BadScene);
}

TEST(Overrides, NameTheFlagAtFault) {
  EXPECT_EQ(errors_of("", {parse_set("amplitde=3")}),
            "--set amplitde=3: unknown key 'amplitde'; did you mean 'motion.amplitude'?");
  EXPECT_EQ(errors_of("", {parse_set("depth=3")}), "--set depth=3: unknown key 'depth'; did you mean 'fluid.depth'?");
  EXPECT_EQ(errors_of("", {{"--spacing big", "particles.spacing", "big"}}),
            "--spacing big: [particles] spacing = 'big' is no number; expected a number above 0, up to 10 [m]");
  EXPECT_EQ(errors_of("", {parse_set("time.end=inf")}),
            "--set time.end=inf: [time] end = inf is not finite; expected a number above 0, up to 100000 [s]");
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
