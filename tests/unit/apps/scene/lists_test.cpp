#include "apps/scene/lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/run/run_json.hpp"
#include "apps/scene/options.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/errors_of.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

const char* sensors =
    "[tank]\nlength = 1\n[sensors]\nenergy = false\n[[sensors.gauge]]\nname = \"mid\"\n"
    "x = 0.3\n[[sensors.pressure]]\nname = \"p1\"\n"
    "y = 0.1\nside = 0.02\n[[sensors.gauge]]\nname = \"right\"\nx = 1\n[[motion.harmonic]]\nof = \"roll\"\n"
    "amplitude = 2.5\nfrequency = 0.5\nphase = -90\n";

TEST(Lists, HaveSectionsWithKeysAndNamesOfTheirOwn) {
  const std::vector<std::string> all = sections();
  std::set<std::string> seen;
  for (const List& list : lists()) {
    EXPECT_EQ(std::count(all.begin(), all.end(), list.section), 1) << dotted(list);
    EXPECT_FALSE(find_option(list.section, list.key)) << dotted(list);
    EXPECT_TRUE(seen.insert(dotted(list)).second) << dotted(list);
  }
}

TEST(Lists, EachKeySetsItsOwnMemberOfItsOwnTableAndNoOther) {
  for (const List& list : lists())
    for (const Member& member : list.members) {
      if (is_of_row(member)) continue;
      Scene scene, fresh;
      list.reset(scene, 2);
      list.reset(fresh, 2);
      const auto* range = std::get_if<Range>(&member.rule);
      const auto* choices = std::get_if<Choices>(&member.rule);
      const auto* tuple = std::get_if<Tuple>(&member.rule);
      const auto* tuples = std::get_if<Tuples>(&member.rule);
      const Value value = range                                         ? Value(range->high)
                          : choices                                     ? Value(std::string(choices->back()))
                          : tuple                                       ? Value(Numbers(tuple->count, 7))
                          : tuples                                      ? Value(Rows(2, Numbers(tuples->count, 7)))
                          : std::holds_alternative<Pairs>(member.rule)  ? Value(Points{{0, 1}, {2, 3}})
                          : std::holds_alternative<Vector>(member.rule) ? Value(Numbers{1, 2, 3})
                                                                        : Value(std::string("other"));
      EXPECT_EQ(assign(list, member, scene, 1, value), std::nullopt) << title(list, member);
      for (const Member& other : list.members) {
        EXPECT_EQ(value_of(other, scene, 0), value_of(other, fresh, 0)) << title(list, member);
        EXPECT_EQ(value_of(other, scene, 1), &other == &member ? value : value_of(other, fresh, 1))
            << title(list, member);
      }
    }
}

TEST(Lists, ATankHasBaffles) {
  const std::string text =
      "[[tank.baffle]]\npoints = [[0.3, 0], [0.3, 0.1]]\nthickness = 0.02\n[[tank.baffle]]\npoints = [[0.1, 0.2], "
      "[0.2, "
      "0.2]]\n[tank]\nshape = \"box\"\n";
  const auto baffles = parse_scene(text, "x.toml", {}).parameters.tank.baffles;
  ASSERT_EQ(baffles.size(), 2u);
  EXPECT_EQ(baffles[0].points, (Points{{0.3, 0}, {0.3, 0.1}}));
  EXPECT_EQ(baffles[0].thickness, 0.02);
  EXPECT_EQ(baffles[1].points.size(), 2u);
  EXPECT_TRUE(parse_scene(text, "x.toml", {parse_set("tank.baffle=[]")}).parameters.tank.baffles.empty());
}

TEST(Lists, ATankHasFlatBafflesAndRings) {
  const std::string text =
      "[tank]\nwidth = 0.2\n[[tank.baffle]]\ncorners = [[0.3, 0, 0], [0.3, 0, 0.2], [0.3, 0.4, 0.2]]\n"
      "holes = [[0.3, 0.2, 0.1, 0.05]]\n[[tank.ring]]\ncentre = [0.45, 0.2, 0.1]\ninner = 0.05\nouter = 0.08\n";
  const auto tank = parse_scene(text, "x.toml", {}).parameters.tank;
  ASSERT_EQ(tank.baffles.size(), 1u);
  EXPECT_EQ(tank.baffles[0].corners, (Triples{{0.3, 0, 0}, {0.3, 0, 0.2}, {0.3, 0.4, 0.2}}));
  EXPECT_EQ(tank.baffles[0].holes, (Quadruples{{0.3, 0.2, 0.1, 0.05}}));
  ASSERT_EQ(tank.rings.size(), 1u);
  EXPECT_EQ(tank.rings[0].centre, (Triple{0.45, 0.2, 0.1}));
  EXPECT_EQ(tank.rings[0].normal, (Triple{0, 1, 0}));
  const std::string wrong =
      errors_of("[[tank.ring]]\ncentre = [0, 1]\ninner = 0.1\n[[tank.baffle]]\nholes = [[0, 0, 0]]\n");
  EXPECT_NE(wrong.find("[[tank.ring]] centre"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("[[tank.baffle]] holes"), std::string::npos) << wrong;
}

TEST(Lists, TablesReachTheirMembersInOrder) {
  const Parameters p = parse_scene(sensors, "x.toml", {}).parameters;
  ASSERT_EQ(p.sensors.gauge.size(), 2u);
  EXPECT_EQ(p.sensors.gauge[0].name, "mid");
  EXPECT_EQ(p.sensors.gauge[0].x, 0.3);
  EXPECT_EQ(p.sensors.gauge[1].name, "right");
  EXPECT_EQ(p.sensors.gauge[1].x, 1.0) << "a whole number serves as a real one";
  ASSERT_EQ(p.sensors.pressure.size(), 1u);
  EXPECT_EQ(p.sensors.pressure[0].side, 0.02);
  ASSERT_EQ(p.motion.harmonics.size(), 1u);
  EXPECT_EQ(p.motion.harmonics[0].of, DegreeOfFreedom::roll);
  EXPECT_EQ(p.motion.harmonics[0].phase, -90);
  EXPECT_FALSE(p.sensors.energy);
}

TEST(Lists, ReadBackFromTheScenesText) {
  const Scene scene = parse_scene(sensors, "x.toml", {});
  for (const std::string& text : {scene_text(scene), explained_scene_text(scene)})
    EXPECT_EQ(scene_text(parse_scene(text, "x.toml", {})), scene_text(scene)) << text;
  EXPECT_NE(scene_hash(scene), scene_hash(parse_scene("[sensors]\nenergy = false\n", "x.toml", {})));
}

TEST(Lists, ThatAreEmptyAreExplainedAllTheSame) {
  const std::string text = explained_scene_text(Scene{});
  EXPECT_NE(text.find("\n# [[sensors.gauge]]"), std::string::npos);
  EXPECT_EQ(scene_text(Scene{}).find("[["), std::string::npos);
}

TEST(Lists, AreReplacedByAnOverride) {
  const Scene scene =
      parse_scene(sensors, "x.toml", {parse_set("sensors.gauge=[{name=\"a\", x=0.1}, {name=\"b\", x=1}]")});
  ASSERT_EQ(scene.parameters.sensors.gauge.size(), 2u);
  EXPECT_EQ(scene.parameters.sensors.gauge[0].name, "a");
  EXPECT_EQ(scene.parameters.sensors.gauge[1].x, 1);
  EXPECT_EQ(scene.parameters.sensors.pressure.size(), 1u) << "the other list stays";
  EXPECT_TRUE(parse_scene(sensors, "x.toml", {parse_set("sensors.gauge=[]")}).parameters.sensors.gauge.empty());
}

TEST(Lists, NameThePlaceOfEachMistake) {
  EXPECT_TRUE(test::tells(
      errors_of("[[sensors.gauge]]\nnam = \"a\"\n"),
      {"x.toml:1:1", "[[sensors.gauge]]", "0-9", "_", "x.toml:2:1", "[[sensors.gauge]]", "nam", "'name'?"}));
  EXPECT_TRUE(
      test::tells(errors_of("[[sensors.gage]]\nname = \"a\"\n"), {"x.toml:1:11", "[sensors]", "gage", "'gauge'?"}));
  EXPECT_TRUE(test::tells(errors_of("[[senors]]\nname = \"a\"\n"), {"x.toml:1:3", "[senors]", "[sensors]?"}));
  EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"a\"\nx = \"left\"\n"),
                          {"x.toml:3:5", "[[sensors.gauge]]", "x", "'left'", "0", "1000", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"a\"\nx = inf\n"),
                          {"x.toml:3:5", "[[sensors.gauge]]", "x", "0", "1000", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"a\"\nx = -2000\n"),
                          {"x.toml:3:5", "[[sensors.gauge]]", "x", "-2000", "-1000", "1000", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"a\"\nx = [1]\n"),
                          {"x.toml:3:5", "[[sensors.gauge]]", "x", "0", "1000", "[m]"}));
  EXPECT_TRUE(test::tells(errors_of("[[motion.harmonic]]\nof = \"rol\"\n"),
                          {"x.toml:2:6", "[[motion.harmonic]]", "of", "'rol'", "'roll'?"}));
  EXPECT_TRUE(test::tells(errors_of("[sensors.gauge]\nname = \"a\"\n"),
                          {"x.toml:1:1", "sensors.gauge", "[[sensors.gauge]]", "above", "[{name", "...}]"}));
}

TEST(Lists, WantNamesThatAreFitForColumnsAndDiffer) {
  for (const char* bad : {"", "Left", "a b", "a-b", "\xc3\xa4"})
    EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"" + std::string(bad) + "\"\n"),
                            {"x.toml:2:8", "[[sensors.gauge]] name", "a-z, 0-9 and _"}));
  EXPECT_TRUE(test::tells(errors_of("[[sensors.gauge]]\nname = \"a\"\n[[sensors.gauge]]\nname = \"a\"\n"),
                          {"x.toml:4:8", "[[sensors.gauge]]", "name", "'a'"}));
  EXPECT_EQ(errors_of("[[sensors.gauge]]\nname = \"a\"\n[[sensors.pressure]]\nname = \"a\"\n"), "no error")
      << "columns of another list begin otherwise";
}

TEST(Lists, NameTheFlagAtFault) {
  EXPECT_TRUE(test::tells(errors_of("", {parse_set("sensors.gauge=[{x=0.1}]")}),
                          {"--set", "sensors.gauge=[{x=0.1}]", "[[sensors.gauge]]", "has", "0-9", "_"}));
  EXPECT_EQ(errors_of("", {parse_set("sensors.gauge=mid")}).substr(0, 25), "--set sensors.gauge=mid: ");
  EXPECT_NE(
      errors_of("", {parse_set("sensors.gauge=mid")}).find("[{name = ..., x = ..., y = ..., z = ..., direction = ..."),
      std::string::npos);
  EXPECT_TRUE(
      test::tells(errors_of("", {parse_set("gauge=[]")}), {"--set", "gauge=[]", "'gauge'", "'sensors.gauge'?"}));
}

TEST(Lists, AreInRunJson) {
  const test::Scratch scratch;
  write_run_json(scratch / "run.json", parse_scene(sensors, "x.toml", {}), {});
  const std::string json = test::read_file(scratch / "run.json");
  EXPECT_NE(json.find("\"side\": 0.02"), std::string::npos) << json;
  EXPECT_NE(json.find("\"of\": \"roll\""), std::string::npos);
}

}  // namespace
}  // namespace seiche::apps
