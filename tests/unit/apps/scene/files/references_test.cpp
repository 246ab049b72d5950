#include "apps/scene/files/references.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/errors_of.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

std::string error_of(const std::string& text) {
  try {
    reference_series(Csv(text, "r.csv"), "eta_left", "m");
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

TEST(Reference, TakesItsColumnWithAndWithoutUnits) {
  for (const char* text : {"t,eta_left\n0,1\n0.5,-2e-1\n", "p [Pa],t [s],eta_left [m]\r\n9,0,1\r\n,0.5,-0.2\r\n\r\n"}) {
    const render::Series series = reference_series(Csv(text, "r.csv"), "eta_left", "m");
    EXPECT_EQ(series.time, (std::vector<double>{0, 0.5}));
    EXPECT_EQ(series.value, (std::vector<double>{1, -0.2}));
  }
}

TEST(Reference, EmptyCellsAreGaps) {
  const auto series = reference_series(Csv("t,eta_left\n0,1\n1,\n2,3\n", "r.csv"), "eta_left", "m");
  ASSERT_EQ(series.value.size(), 3u);
  EXPECT_TRUE(std::isnan(series.value[1]));
  EXPECT_EQ(series.value[2], 3);
}

TEST(Reference, BeginsWhereItIsToldTo) {
  const Csv table("t,eta_left\n0,1\n0.5,2\n1,3\n", "r.csv");
  const auto series = reference_series(table, "eta_left", "m", 0.5);
  EXPECT_EQ(series.time, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(series.value, (std::vector<double>{2, 3}));
  try {
    reference_series(table, "eta_left", "m", 0.6);
    FAIL();
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {"r.csv:4: ", "1", "0.6 s", "2"}));
  }
}

TEST(Reference, NamesTheLineOfAMistakeAndWhatWasExpected) {
  EXPECT_TRUE(test::tells(error_of(""), {"r.csv:1: ", "empty"}));
  EXPECT_TRUE(test::tells(error_of("time,eta_left\n0,1\n"), {"r.csv:1", "[s]"}));
  EXPECT_TRUE(test::tells(error_of("t [ms],eta_left\n0,1\n"), {"r.csv:1", "[s]"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_lft,p\n0,1,2\n"), {"r.csv:1", "'eta_left'", "eta_lft", "'eta_lft'?"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left [mm]\n0,1\n"), {"r.csv:1", "'eta_left", "[mm]'", "[m]"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left\n0,1\n"), {"r.csv:2", "1", "2"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left\n0,1\n0.1,2,3\n"), {"r.csv:3", "3", "2"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left\n0,1\n0.1,2 m\n"), {"r.csv:3", "eta_left", "'2", "m'", "-1.5e-3"}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left\n0,1\n,2\n"), {"r.csv:3: t "}));
  EXPECT_TRUE(test::tells(error_of("t,eta_left\n1,1\n0.5,2\n"), {"r.csv:3", "0.5", "1"}));
}

struct SceneWithReference : ::testing::Test {
  test::Scratch scratch;
  std::string scene = scratch / "sub/x.toml";

  Scene read(const std::string& csv, const std::string& more = "") {
    test::write_text(scratch / "sub/data/theory.csv", csv);
    test::write_text(scene, "[[look.reference]]\nof = \"eta_left\"\nfile = \"data/theory.csv\"\n" + more);
    return read_scene(scene, {});
  }

  std::string error(const std::string& more) {
    try {
      read("t,eta_left\n0,1\n1,2\n", more);
    } catch (const BadScene& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(SceneWithReference, ReadsItBesideTheSceneAndNamesItAfterTheFile) {
  const Scene first = read("t,eta_left\n0,1\n1,2\n");
  ASSERT_EQ(first.look.references.size(), 1u);
  EXPECT_EQ(first.look.references[0].label, "theory");
  EXPECT_EQ(first.look.references[0].series.value, (std::vector<double>{1, 2}));
  const Scene other = read("t,z\n0,5\n1,2\n", "column = \"z\"\nlabel = \"Theory of 1920\"\n");
  EXPECT_EQ(other.look.references[0].label, "Theory of 1920");
  EXPECT_EQ(other.look.references[0].series.value, (std::vector<double>{5, 2}));
  EXPECT_EQ(read("t,eta_left\n0,1\n1,2\n2,3\n", "from = 1\n").look.references[0].series.value,
            (std::vector<double>{2, 3}));
}

TEST_F(SceneWithReference, HashesWhatTheFileHolds) {
  const std::string hash = scene_hash(read("t,eta_left\n0,1\n1,2\n"));
  EXPECT_EQ(scene_hash(read("t [s],eta_left [m]\n0,1\n1,2\n\n")), hash);
  EXPECT_NE(scene_hash(read("t,eta_left\n0,1\n1,3\n")), hash);
}

TEST_F(SceneWithReference, SensorsThatArentThereAreNamedWithTheNearestOne) {
  EXPECT_TRUE(test::tells(error("[[look.reference]]\nof = \"eta_lft\"\nfile = \"data/theory.csv\"\n"),
                          {scene + ":5:6: ", "[[look.reference]] of = 'eta_lft'", "p_left_bottom", "eta_right",
                           "force_x", "volume", "'eta_left'?"}));
  EXPECT_TRUE(test::tells(error("[look]\ncurves = \"eta_left, p_roof\"\n"),
                          {scene + ":5:10: ", "[look] curves = 'p_roof'", "p_left_bottom", "eta_left", "y_mass"}));
}

TEST_F(SceneWithReference, SensorsThatArentThereAreNamedInTheOrderOfTheFileThenOfTheFlags) {
  const std::string text = "[[look.reference]]\nof = \"a\"\nfile = \"r.csv\"\n[look]\ncurves = \"eta_left, b, c\"\n";
  const auto places = [&](const std::vector<Override>& overrides) {
    std::istringstream all(errors_of(text, overrides));
    std::string found;
    for (std::string line; std::getline(all, line);) found += line.substr(0, line.find("' ") + 1) + "\n";
    return found;
  };
  EXPECT_EQ(places({}),
            "x.toml:2:6: [[look.reference]] of = 'a'\n"
            "x.toml:5:10: [look] curves = 'b'\n"
            "x.toml:5:10: [look] curves = 'c'\n");
  const std::string list = "look.reference=[{of=\"d\", file=\"r.csv\"}]";
  EXPECT_EQ(places({parse_set("look.curves=none"), parse_set(list)}),
            "--set " + list + ": [[look.reference]] of = 'd'\n");
}

TEST_F(SceneWithReference, ThatIsMissingIsNamed) {
  EXPECT_TRUE(test::tells(error("[[look.reference]]\nof = \"eta_left\"\nfile = \"no.csv\"\n"),
                          {(scratch / "sub/no.csv").string(), "isn't there"}));
}

}  // namespace
}  // namespace seiche::apps
