// Whole runs of small scenes: what they write, and that they write the same twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/program.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

const std::string quick = SEICHE_SCENES "/quick.toml";

// The quick scene, shorter and with smaller pictures.
std::vector<std::string> short_run(std::vector<std::string> more = {}) {
  std::vector<std::string> all{"run", quick, "--end", "0.2", "--threads", "2", "--set", "output.size=320x240"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

long files_in(const fs::path& folder) {
  return fs::exists(folder) ? std::distance(fs::directory_iterator(folder), fs::directory_iterator()) : 0;
}

// Every file under a folder with its bytes; run.json and report.html without their timings.
std::map<std::string, std::string> everything_in(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string& text = all[fs::relative(entry.path(), folder)] = read_file(entry.path());
    if (entry.path().filename() == "report.html") text = std::regex_replace(text, std::regex("Wall time.*"), "");
    if (entry.path().filename() != "run.json") continue;
    nlohmann::json json = nlohmann::json::parse(text);
    json.erase("seconds");
    json.erase("speed");
    text = json.dump();
  }
  return all;
}

TEST(Run, TheQuickSceneWritesEverything) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"run", quick});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* line : {"  movie     out/quick/quick.mp4\n", "  pictures  out/quick/frames/\n",
                           "  ParaView  out/quick/quick.pvd\n", "  curves    out/quick/probes.csv\n",
                           "  record    out/quick/run.json\n", "  report    out/quick/report.html\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << result.out;
  }
  const fs::path out = scratch / "out/quick";
  EXPECT_EQ(files_in(out / "frames"), 26);
  EXPECT_EQ(files_in(out / "vtu"), 26);
  EXPECT_TRUE(fs::exists(out / "quick.pvd"));
  EXPECT_TRUE(fs::exists(out / "quick.vtu.series"));
  EXPECT_EQ(output_of("ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames -of csv=p=0 " +
                      (out / "quick.mp4").string()),
            "640,480,26\n");

  const std::string csv = read_file(out / "probes.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "t [s],p_left_bottom [Pa],eta_left [m],eta_right [m],force_x [N/m],force_y [N/m],moment [N m/m],"
            "kinetic_energy [J/m],potential_energy [J/m],volume [m^2],x_mass [m],y_mass [m],surge [m]");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1002) << "a header, then 0 to 1 s at 1 kHz";

  EXPECT_NE(read_file(out / "report.html").find("survived 1 s"), std::string::npos);

  const nlohmann::json report = nlohmann::json::parse(read_file(out / "run.json"));
  EXPECT_EQ(report["run"], (nlohmann::json{{"status", "finished"}, {"time_s", 1.0}, {"frames", 26}}));
  EXPECT_EQ(report["particles"]["fluid"], 300);
  EXPECT_EQ(report["particles"]["leaked"], 0);
  for (const char* name : {"solve", "pictures", "vtu", "probes", "waited_for_outputs", "total"})
    EXPECT_TRUE(report["seconds"].contains(name)) << name;
  EXPECT_GT(report["speed"]["particle_steps_per_second"], 0);
  EXPECT_NE(result.out.find(" particle-steps a second: "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("  outputs   pictures "), std::string::npos) << result.out;
}

TEST(Run, TwiceTheSameSceneGivesTheSameBytes) {
  const Scratch scratch;
  for (const char* folder : {"one", "two"}) {
    const Result result = seiche(scratch.folder(), short_run({"-o", folder}));
    ASSERT_EQ(result.code, 0) << result.err;
  }
  const auto one = everything_in(scratch / "one"), two = everything_in(scratch / "two");
  EXPECT_GT(one.size(), 12u);
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [name, bytes] : one) EXPECT_TRUE(two.at(name) == bytes) << name;
}

TEST(Run, EachOutputCanBeSwitchedOff) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), short_run({"--set", "output.pictures=false", "--set",
                                                            "output.movie=none", "--set", "output.vtu=false", "--set",
                                                            "output.probes=false", "--set", "output.report=false"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(files_in(scratch / "out/quick"), 1);
  EXPECT_TRUE(fs::exists(scratch / "out/quick/run.json"));
}

TEST(Run, QuietSaysNothing) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), short_run({"--quiet"}));
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST(Run, OverwritingReplacesTheRunAndKeepsAStrangersFiles) {
  const Scratch scratch;
  ASSERT_EQ(seiche(scratch.folder(), short_run()).code, 0);
  const fs::path out = scratch / "out/quick";
  ASSERT_EQ(files_in(out / "frames"), 6);
  write_text(out / "notes.txt", "mine");
  write_text(out / "frames/best.png", "mine");

  ASSERT_EQ(seiche(scratch.folder(), short_run({"--end", "0.12", "--overwrite"})).code, 0);
  EXPECT_EQ(files_in(out / "frames"), 4 + 1);
  EXPECT_EQ(files_in(out / "vtu"), 4);
  EXPECT_EQ(read_file(out / "notes.txt"), "mine");
  EXPECT_EQ(read_file(out / "frames/best.png"), "mine");
}

TEST(Run, AFailingRunSaysWhyAndKeepsItsFrames) {
  const Scratch scratch;
  // The paper's scheme with KF2 and its alpha = 3 blows up at once.
  const Result result = seiche(scratch.folder(), {"run", quick, "--set", "preset=paper", "--kernel", "KF2", "--set",
                                                  "output.frame_rate=200", "--set", "output.size=320x240"});
  EXPECT_EQ(result.code, 1);
  const fs::path out = scratch / "out/quick";
  const nlohmann::json report = nlohmann::json::parse(read_file(out / "run.json"));
  EXPECT_EQ(report["run"]["status"], "failed");
  const std::string cause = report["run"]["failure"]["cause"];
  EXPECT_TRUE(test::tells(result.err, {"seiche: ", cause}));
  EXPECT_NE(read_file(out / "report.html").find("stopped at "), std::string::npos);
  const long frames = report["run"]["frames"];
  EXPECT_GE(frames, 2);
  EXPECT_EQ(files_in(out / "frames"), frames);
  EXPECT_EQ(files_in(out / "vtu"), frames);
  EXPECT_EQ(output_of("ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 " +
                      (out / "quick.mp4").string()),
            std::to_string(frames) + "\n");
}

}  // namespace
}  // namespace seiche::test
