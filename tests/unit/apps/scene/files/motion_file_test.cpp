#include "apps/scene/files/motion_file.hpp"

#include <gtest/gtest.h>

#include "apps/commands/check.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

const std::string good = "t [s],surge [m],roll [deg]\n0,0,0\n0.1,0.01,-2\n0.2,0.02,1e-1\n0.35,0.01,0\n";

std::string error_of(const std::string& text) {
  try {
    parse_motion(text, "m.csv");
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

TEST(MotionFile, HasItsColumnsInAnyOrderAndWithAnySpaces) {
  for (const std::string& text :
       {good, std::string("\xef\xbb\xbfroll [deg] , t [s],surge [m]\r\n0,0,0\r\n -2 ,0.1,0.01\r\n"
                          "0.1,0.2,0.02\r\n0,0.35,0.01\r\n\r\n\n")}) {
    const Parameters::TimeSeries series = parse_motion(text, "m.csv");
    EXPECT_EQ(series.time, (std::vector<double>{0, 0.1, 0.2, 0.35}));
    EXPECT_EQ(series[DegreeOfFreedom::surge], (std::vector<double>{0, 0.01, 0.02, 0.01}));
    EXPECT_EQ(series[DegreeOfFreedom::roll], (std::vector<double>{0, -2, 0.1, 0}));
    EXPECT_TRUE(series[DegreeOfFreedom::heave].empty());
  }
}

TEST(MotionFile, ConvertsUnits) {
  const auto series =
      parse_motion("t [ms],surge [mm],heave [cm],roll [rad]\n0,5,5,1\n10,5,5,1\n20,5,5,1\n30,5,5,1\n", "");
  EXPECT_DOUBLE_EQ(series.time[3], 0.03);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::surge][0], 0.005);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::heave][0], 0.05);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::roll][0], 57.295779513082323);
}

TEST(MotionFile, NamesTheLineOfAMistakeAndWhatWasExpected) {
  EXPECT_TRUE(test::tells(error_of(""), {"m.csv:1: ", "empty"}));
  for (const auto& [text, wrong] : {std::pair{"t [s],sway [m]\n0,0\n", "'sway [m]'"},
                                    {"t,surge [m]\n0,0\n", "'t'"},
                                    {"t [s],surge [inch]\n", "'surge [inch]'"},
                                    {"surge [m]\n0\n", "times"},
                                    {"t [s]\n0\n", "motion"}})
    EXPECT_TRUE(
        test::tells(error_of(text), {"m.csv:1: ", wrong, "t [s]", "surge [m]", "heave [m]", "roll [deg]", "mm"}));
  EXPECT_TRUE(test::tells(error_of("t [s],surge [m],surge [mm]\n"), {"m.csv:1", "'surge", "[mm]'"}));
  const std::string head = "t [s],surge [m]\n0,0\n0.1,0\n";
  EXPECT_TRUE(test::tells(error_of(head + "0.2\n"), {"m.csv:4", "1", "2"}));
  EXPECT_TRUE(test::tells(error_of(head + "\n0.2,0\n"), {"m.csv:4", "1", "2"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.2,\n"), {"m.csv:4", "[m]"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.2,x1\n"), {"m.csv:4", "[m]", "'x1'", "-1.5e-3"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.2,1.5 m\n"), {"m.csv:4", "[m]", "'1.5", "m'", "-1.5e-3"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.2,nan\n"), {"m.csv:4", "[m]"}));
  EXPECT_TRUE(test::tells(error_of(head + "inf,0\n"), {"m.csv:4", "[s]"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.1,1\n"), {"m.csv:4", "0.1", "0.1"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.05,1\n"), {"m.csv:4", "0.05", "0.1"}));
  EXPECT_TRUE(test::tells(error_of(head + "0.2,0\n"), {"m.csv:4", "3", "4"}));
}

struct SceneWithMotion : ::testing::Test {
  test::Scratch scratch;
  std::string scene = scratch / "sub/x.toml";
  Scene read(const std::string& csv, const std::string& end = "0.35") {
    test::write_text(scratch / "sub/m.csv", csv);
    test::write_text(scene, "[motion]\ntype = \"file\"\nfile = \"m.csv\"\n[time]\nend = " + end + "\n");
    return read_scene(scene, {});
  }
};

TEST_F(SceneWithMotion, ReadsItBesideTheScene) {
  const Scene moved = read(good);
  EXPECT_EQ(moved.parameters.motion.series[DegreeOfFreedom::surge].size(), 4u);
  EXPECT_NE(check_text(moved).find("moved by 4 samples of m.csv, impulsive start"), std::string::npos);
}

TEST_F(SceneWithMotion, HashesWhatTheFileHolds) {
  const std::string hash = scene_hash(read(good));
  EXPECT_EQ(scene_hash(read(good + "\n")), hash);
  EXPECT_NE(scene_hash(read(good.substr(0, good.size() - 2) + "1\n")), hash);
}

TEST_F(SceneWithMotion, WantsAFileAsLongAsTheRun) {
  const auto error = [&](const std::string& csv, const std::string& end) -> std::string {
    try {
      read(csv, end);
    } catch (const BadScene& refusal) {
      return refusal.what();
    }
    return "no error";
  };
  EXPECT_TRUE(test::tells(error(good, "0.4"), {scene, "motion.file", "0 to 0.35 s", "0 to 0.4 s", "time.end"}));
  EXPECT_TRUE(test::tells(error("t [s],heave [m]\n0.1,0\n0.2,0\n0.3,0\n0.5,0\n", "0.35"), {"0.1 to 0.5 s"}));
  EXPECT_EQ(error(good, "0.35"), "no error");
}

TEST_F(SceneWithMotion, ThatIsMissingIsNamed) {
  test::write_text(scene, "[motion]\ntype = \"file\"\nfile = \"n\\\"o.csv\"\n");
  try {
    read_scene(scene, {});
    ADD_FAILURE();
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {(scratch / "sub/n\"o.csv").string(), "isn't there"}));
  }
}

}  // namespace
}  // namespace seiche::apps
