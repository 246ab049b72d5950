#include "apps/scene/files/motion_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/commands/check.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

const std::string good = "t [s],surge [m],roll [deg]\n0,0,0\n0.1,0.01,-2\n0.2,0.02,1e-1\n0.35,0.01,0\n";

Parameters::TimeSeries read(const std::string& text, const std::string& columns = "",
                            const Parameters::Motion& motion = {}) {
  return parse_motion(text, "m.csv", motion, columns);
}

std::string error_of(const std::string& text, const std::string& columns = "", const Parameters::Motion& motion = {}) {
  try {
    read(text, columns, motion);
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

TEST(MotionFile, HasItsColumnsInAnyOrderAndWithAnySpaces) {
  for (const std::string& text :
       {good, std::string("\xef\xbb\xbfroll [deg] , t [s],surge [m]\r\n0,0,0\r\n -2 ,0.1,0.01\r\n"
                          "0.1,0.2,0.02\r\n0,0.35,0.01\r\n\r\n\n")}) {
    const Parameters::TimeSeries series = read(text);
    EXPECT_EQ(series.time, (std::vector<double>{0, 0.1, 0.2, 0.35}));
    EXPECT_EQ(series[DegreeOfFreedom::surge], (std::vector<double>{0, 0.01, 0.02, 0.01}));
    EXPECT_EQ(series[DegreeOfFreedom::roll], (std::vector<double>{0, -2, 0.1, 0}));
    EXPECT_TRUE(series[DegreeOfFreedom::heave].empty());
  }
}

TEST(MotionFile, ConvertsUnits) {
  const auto series = read("t [ms],surge [mm],heave [cm],roll [rad]\n0,5,5,1\n10,5,5,1\n20,5,5,1\n30,5,5,1\n");
  EXPECT_DOUBLE_EQ(series.time[3], 0.03);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::surge][0], 0.005);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::heave][0], 0.05);
  EXPECT_DOUBLE_EQ(series[DegreeOfFreedom::roll][0], 57.295779513082323);
}

TEST(MotionFile, NamesTheLineOfAMistakeAndWhatWasExpected) {
  EXPECT_TRUE(test::tells(error_of(""), {"m.csv:1: ", "empty"}));
  for (const auto& [text, wrong] : {std::pair{"t [s],swoy [m]\n0,0\n", "'swoy [m]'"},
                                    {"t [h],surge [m]\n0,0\n", "'t [h]'"},
                                    {"t [s],surge [inch]\n", "'surge [inch]'"},
                                    {"t [s],surge [deg]\n", "'surge [deg]'"},
                                    {"t [s],surge\n", "'surge'"},
                                    {"surge [m]\n0\n", "times"},
                                    {"t [s]\n0\n", "motion"}})
    EXPECT_TRUE(
        test::tells(error_of(text), {"m.csv:1: ", wrong, "t [s]", "surge", "sway [m]", "yaw [deg]", "mm", "m/s^2"}));
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

TEST(MotionFile, TakesAllSixAndATimeWithoutAUnitInSeconds) {
  std::string text = "time,sway [m],pitch [deg],yaw [rad],surge [m],heave [m],roll [deg]\n";
  for (int k = 0; k < 4; ++k) text += std::to_string(k) + ",1,2,3,4,5,6\n";
  const auto series = read(text);
  EXPECT_EQ(series.time, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(series[DegreeOfFreedom::sway][3], 1);
  EXPECT_EQ(series[DegreeOfFreedom::pitch][3], 2);
  EXPECT_NEAR(series[DegreeOfFreedom::yaw][3], 171.887338539247, 1e-9);
  EXPECT_EQ(series[DegreeOfFreedom::heave][3], 5);
}

const std::string gauged = "t [s],roll [deg],P1 [mbar]\n0,0,3\n1,2,x\n2,4,3\n3,3,3\n";

TEST(MotionFile, IgnoresColumnsThatArentAskedFor) {
  const auto series = read(gauged, " roll ");
  EXPECT_EQ(series[DegreeOfFreedom::roll], (std::vector<double>{0, 2, 4, 3}));
  EXPECT_EQ(read(gauged, "t,roll")[DegreeOfFreedom::roll].size(), 4u);
  EXPECT_TRUE(test::tells(error_of(gauged), {"m.csv:1: ", "'P1 [mbar]'", "motion.columns"}));
  EXPECT_TRUE(test::tells(error_of(gauged, "roll,yaw"), {"m.csv:1: ", "'yaw'", "missing", "roll [deg], P1 [mbar]"}));
  EXPECT_TRUE(test::tells(error_of(gauged, "roll,P1"), {"m.csv:1: ", "P1"}));
}

TEST(MotionFile, MakesAnglesThatWrapContinuous) {
  EXPECT_EQ(read("t,yaw [deg]\n0,170\n1,179\n2,-175\n3,-160\n")[DegreeOfFreedom::yaw],
            (std::vector<double>{170, 179, 185, 200}));
}

TEST(MotionFile, IntegratesAccelerationsTwiceInTheirUnits) {
  std::string text = "t [s],surge [g],heave [mm/s^2],roll [rad/s^2]\n";
  for (int k = 0; k <= 400; ++k) {
    const double wave = std::sin(0.1 * k);  // at 1 rad/s over 6.4 periods
    text += fmt::format("{},{},{},{}\n", 0.1 * k, wave, wave, wave);
  }
  const auto series = read(text);
  // A tenth of the way is left to the parabola that is taken out as drift.
  for (std::size_t k = 100; k < 300; ++k) {
    const double way = -std::sin(0.1 * static_cast<double>(k));
    EXPECT_NEAR(series[DegreeOfFreedom::surge][k] / 9.80665, way, 0.1);
    EXPECT_NEAR(series[DegreeOfFreedom::heave][k] / 1e-3, way, 0.1);
    EXPECT_NEAR(series[DegreeOfFreedom::roll][k] / 57.295779513, way, 0.1);
  }
}

const std::string openfoam =
    "// six degrees of freedom\n4\n(\n(0 ((0 0 0) (0 0 0)))\n/* a\ncomment */ (0.5 ((1 2 3) (4 5 6)))\n"
    "(1 ((1 2 3) (4e0 -5 6)))\n(2((1 2 3)(4 5 6)))\n)\n";

TEST(MotionFile, ReadsOpenFoamsTablesAlongTheAxesOfTheMotion) {
  Parameters::Motion tank;
  tank.rotation_order = RotationOrder::xyz;
  const auto series = read(openfoam, "", tank);
  EXPECT_EQ(series.time, (std::vector<double>{0, 0.5, 1, 2}));
  EXPECT_EQ(series[DegreeOfFreedom::surge][1], 1);
  EXPECT_EQ(series[DegreeOfFreedom::heave][1], 2);
  EXPECT_EQ(series[DegreeOfFreedom::sway][1], 3);
  EXPECT_EQ(series[DegreeOfFreedom::pitch][1], 4);
  EXPECT_EQ(series[DegreeOfFreedom::yaw][2], -5);
  EXPECT_EQ(series[DegreeOfFreedom::roll][1], 6);
  Parameters::Motion ship = tank;
  ship.axes = MotionAxes::ship;
  const auto of_ship = read(openfoam, "", ship);
  EXPECT_EQ(of_ship[DegreeOfFreedom::sway][1], 2);
  EXPECT_EQ(of_ship[DegreeOfFreedom::heave][1], 3);
  EXPECT_EQ(of_ship[DegreeOfFreedom::roll][1], 4);
  EXPECT_TRUE(read(openfoam, "surge", ship)[DegreeOfFreedom::roll].empty());
}

TEST(MotionFile, SaysWhatIsWrongWithAnOpenFoamTable) {
  EXPECT_TRUE(test::tells(error_of(openfoam), {"m.csv", "rotation_order", "xyz"}));
  EXPECT_TRUE(test::tells(error_of("(\n(0 ((0 0) (0 0 0)))\n)"), {"m.csv:2: ", "')'", "number"}));
  EXPECT_TRUE(test::tells(error_of("(\n(0 ((0 0 0) (0 0 0)))\n"), {"m.csv:2: ", "ends"}));
  EXPECT_TRUE(test::tells(error_of("(\n(0 ((0 0 0) (0 0 0)))\n(0 ((0 0 0) (0 0 0))))"), {"m.csv:3: ", "after"}));
  EXPECT_TRUE(test::tells(error_of("((0 ((0 0 0) (0 0 0))))"), {"m.csv:1: ", "1 samples", "4"}));
  EXPECT_TRUE(test::tells(error_of("((0 ((0 x 0) (0 0 0))))"), {"m.csv:1: ", "'x'"}));
}

const std::string path =
    "#time;x;y;z;ax;ay;az\n0;5;6;7;0;0;0\n1;6;6;9;10;20;30\n\n2 6 6 9 10 20 30\n3,6,6,9,10,20,30\n";

TEST(MotionFile, ReadsPathsWithoutTitlesFromWhereTheyBegin) {
  Parameters::Motion ship;
  ship.axes = MotionAxes::ship;
  const auto series = read(path, "", ship);
  EXPECT_EQ(series.time, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(series[DegreeOfFreedom::surge], (std::vector<double>{0, 1, 1, 1}));
  EXPECT_EQ(series[DegreeOfFreedom::heave], (std::vector<double>{0, 2, 2, 2}));
  EXPECT_EQ(series[DegreeOfFreedom::roll][1], 10);
  EXPECT_EQ(series[DegreeOfFreedom::yaw][1], 30);
  EXPECT_TRUE(read("0 1 2 3\n1 1 2 3\n2 1 2 3\n3 1 2 3\n")[DegreeOfFreedom::roll].empty());
}

TEST(MotionFile, WithoutTitlesNeedsItsColumnsNamed) {
  const std::string text = "0 5\n1 6\n2 7\n3 8\n";
  EXPECT_EQ(read(text, "t, roll")[DegreeOfFreedom::roll], (std::vector<double>{5, 6, 7, 8}));
  EXPECT_TRUE(test::tells(error_of(text), {"m.csv:1: ", "2 numbers", "motion.columns", "t, roll"}));
  EXPECT_TRUE(test::tells(error_of(text, "t, roll, yaw"), {"m.csv:1: ", "2 numbers"}));
  EXPECT_TRUE(test::tells(error_of(text, "t, rall"), {"m.csv:1: ", "'rall'"}));
  EXPECT_TRUE(test::tells(error_of(text, "roll, yaw"), {"m.csv:1: ", "time"}));
  EXPECT_TRUE(test::tells(error_of(text, "t, t"), {"m.csv:1: ", "'t'", "second"}));
  EXPECT_TRUE(test::tells(error_of(text + "4 y\n", "t, roll"), {"m.csv:5: ", "'y'"}));
  EXPECT_TRUE(test::tells(error_of(text + "4\n", "t, roll"), {"m.csv:5: ", "1 cells", "2"}));
  EXPECT_TRUE(test::tells(error_of(text + "3 1\n", "t, roll"), {"m.csv:5: ", "after"}));
}

struct SceneWithMotion : ::testing::Test {
  test::Scratch scratch;
  std::string scene = scratch / "sub/x.toml";
  Scene read(const std::string& csv, const std::string& end = "0.35", const std::string& keys = "") {
    test::write_text(scratch / "sub/m.csv", csv);
    test::write_text(scene, "[motion]\ntype = \"file\"\nfile = \"m.csv\"\n" + keys + "[time]\nend = " + end + "\n");
    return read_scene(scene, {});
  }
};

TEST_F(SceneWithMotion, ReadsItBesideTheScene) {
  const Scene moved = read(good);
  EXPECT_EQ(moved.parameters.motion.series[DegreeOfFreedom::surge].size(), 4u);
  EXPECT_NE(check_text(moved).find("moved by 4 samples of m.csv, impulsive start, at most "), std::string::npos);
}

TEST_F(SceneWithMotion, HashesWhatTheFileHolds) {
  const std::string hash = scene_hash(read(good));
  EXPECT_EQ(scene_hash(read(good + "\n")), hash);
  EXPECT_NE(scene_hash(read(good.substr(0, good.size() - 2) + "1\n")), hash);
}

TEST_F(SceneWithMotion, WantsAFileAsLongAsTheRun) {
  const auto error = [&](const std::string& csv, const std::string& end, const std::string& keys = "") -> std::string {
    try {
      read(csv, end, keys);
    } catch (const BadScene& refusal) {
      return refusal.what();
    }
    return "no error";
  };
  EXPECT_TRUE(test::tells(error(good, "0.4"),
                          {scene, "motion.file", "0.35 s", "0.4 s", "time.end = 0.35", "motion.hold = true"}));
  const std::string late = "t [s],heave [m]\n0.1,0\n0.2,0\n0.3,0\n0.5,0\n";
  EXPECT_TRUE(test::tells(error(late, "0.35"), {"begins at 0.1 s", "motion.from = 0.1", "motion.hold = true"}));
  EXPECT_EQ(error(late, "0.35", "from = 0.1\n"), "no error");
  EXPECT_EQ(error(late, "0.7", "hold = true\n"), "no error");
  EXPECT_TRUE(test::tells(error(late, "0.05", "hold = true\n"), {"0.1 to 0.5 s", "motion.from"}));
  EXPECT_TRUE(test::tells(error(late, "0.05", "from = 9\n"), {"ends at 0.5 s", "smaller motion.from"}));
  EXPECT_EQ(error(good, "0.35"), "no error");
}

TEST_F(SceneWithMotion, RefusesByNameWhatLeavesThePlane) {
  const std::string six = "t,sway [m],pitch [deg],roll [deg],yaw [deg]\n0,0,0,0,0\n1,1,0,2,0\n2,0,0,0,0\n3,1,0,1,0\n";
  try {
    read(six);
    ADD_FAILURE();
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {"sway would leave the plane", "surge, heave, roll", "columns = \"roll\""}));
  }
  EXPECT_NO_THROW(read(six, "0.35", "columns = \"roll\"\n"));
  const Scene ship = read(six, "0.35", "axes = \"ship\"\ntank_x = \"port\"\n");
  EXPECT_TRUE(test::tells(check_text(ship), {"heave +y", "sway +x", "roll about +z", "axes = \"ship\""}));
}

TEST_F(SceneWithMotion, AsksForTheTanksPlaceInTheShip) {
  try {
    read(good, "0.35", "axes = \"ship\"\n");
    ADD_FAILURE();
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {"tank_x", "\"forward\"", "\"port\""}));
  }
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
