// Runs that are drawn and filmed again, done or still going.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "tests/cli/program.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

const std::string quick = SEICHE_SCENES "/quick.toml";

// The quick scene with small pictures.
std::vector<std::string> run_until(const std::string& end, std::vector<std::string> more = {}) {
  std::vector<std::string> all{"run", quick, "--end", end, "--threads", "2", "--set", "output.size=320x240"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

long pictures_in(const fs::path& folder) {
  long count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ".png";
  return count;
}

// As in "320,240,25/1,6": width, height, rate, frames.
std::string facts_of(const fs::path& movie) {
  const std::string facts = output_of(
      "ffprobe -v error -count_frames -show_entries stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
      movie.string() + "'");
  return facts.substr(0, facts.find('\n'));
}

struct Replay : testing::Test {
  Scratch scratch;
  const fs::path out = scratch / "out/quick";
  void run(const std::vector<std::string>& arguments) {
    const Result result = seiche(scratch.folder(), arguments);
    ASSERT_EQ(result.code, 0) << result.err;
  }
};

TEST_F(Replay, DrawsWhatTheRunDrew) {
  run(run_until("0.2", {"--set", "look.curves=none"}));
  run({"render", "out/quick"});
  ASSERT_EQ(pictures_in(out / "render"), 6);
  for (const auto& entry : fs::directory_iterator(out / "render"))
    EXPECT_TRUE(read_file(entry.path()) == read_file(out / "frames" / entry.path().filename())) << entry.path();
}

TEST_F(Replay, SaysWhatItMadeAndWhere) {
  run(run_until("0.2"));
  const Result result = seiche(scratch.folder(), {"render", "out/quick", "--from", "0.08", "--size", "160x120",
                                                  "--colour-map", "cividis", "--movie", "webm", "-o", "again"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("Done: 4 frames in "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("  pictures  again/\n  movie     again/quick.webm\n"), std::string::npos) << result.out;
  EXPECT_EQ(pictures_in(scratch / "again"), 4);
  EXPECT_TRUE(fs::exists(scratch / "again/000002.png")) << "numbered as in the run";
  EXPECT_EQ(facts_of(scratch / "again/quick.webm"), "160,120,25/1,4");
}

TEST_F(Replay, FilmsPicturesAsTheyAreAndVtuFilesOtherwise) {
  run(run_until("0.2"));
  run({"movie", "out/quick", "--quiet"});
  EXPECT_EQ(facts_of(out / "render/quick.mp4"), "320,240,25/1,6");
  run({"movie", "out/quick", "-o", "slow.mp4", "--speed", "0.2", "--frames", "2:4"});
  EXPECT_EQ(facts_of(scratch / "slow.mp4"), "320,240,5/1,3");
  run({"movie", "out/quick", "-o", "lab.gif", "--view", "lab", "--size", "101x95", "--fps", "10"});
  EXPECT_EQ(facts_of(scratch / "lab.gif"), "101,95,10/1,6");
}

TEST_F(Replay, DrawsAnewWhatPicturesAreMissing) {
  run(run_until("0.2"));
  fs::remove(out / "frames/000003.png");
  run({"movie", "out/quick", "-o", "a.mp4"});
  EXPECT_EQ(facts_of(scratch / "a.mp4"), "320,240,25/1,6");
  for (const char* last : {"frames/000000.png", "frames/000005.png"}) fs::remove(out / last);
  run({"movie", "out/quick", "-o", "ends.mp4"});
  EXPECT_EQ(facts_of(scratch / "ends.mp4"), "320,240,25/1,6");
  fs::remove(out / "vtu/quick_000004.vtu");
  for (const std::string verb : {"render", "movie"}) {
    const Result result = seiche(scratch.folder(), {verb, "out/quick", "-o", "none.mp4"});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(test::tells(result.err, {"out/quick/vtu/quick_000004.vtu", "run it again"}));
    EXPECT_FALSE(fs::exists(scratch / "none.mp4"));
  }
  run({"movie", "out/quick", "-o", "b.mp4", "--frames", "1:2"});
  EXPECT_EQ(facts_of(scratch / "b.mp4"), "320,240,25/1,2") << "whose pictures are there";
}

TEST_F(Replay, AMovieThatIsReplacedStaysUntilTheOtherIsWhole) {
  run(run_until("0.2"));
  run({"movie", "out/quick", "-o", "a.mp4"});
  const std::string before = read_file(scratch / "a.mp4");
  write_text(out / "vtu/quick_000004.vtu", "damaged");
  const Result result =
      seiche(scratch.folder(), {"movie", "out/quick", "--style", "dot", "-o", "a.mp4", "--overwrite"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(test::tells(result.err, {"quick_000004.vtu", "damaged", "Kept: 0 frames in ", "  as before a.mp4\n"}));
  EXPECT_TRUE(read_file(scratch / "a.mp4") == before);
  EXPECT_FALSE(fs::exists(scratch / ".part-a.mp4"));
  run({"movie", "out/quick", "--speed", "0.5", "-o", "a.mp4", "--overwrite"});
  EXPECT_EQ(facts_of(scratch / "a.mp4"), "320,240,25/2,6");
}

TEST_F(Replay, BadInputIsRefusedInOneSentenceAndNothingIsWritten) {
  run(run_until("0.04"));
  fs::create_directories(scratch / "empty");
  write_text(scratch / "half/run.json", "{\"seiche\": \"0.1");
  const auto error_of = [&](const std::vector<std::string>& arguments) {
    const Result result = seiche(scratch.folder(), arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  for (const std::string verb : {"render", "movie"}) {
    for (const std::string folder : {"nowhere", "empty", "out"})
      EXPECT_TRUE(test::tells(error_of({verb, folder}), {"seiche: " + folder, "`seiche run`"}));
    EXPECT_TRUE(test::tells(error_of({verb, "half"}), {"seiche: half/run.json", "byte 16"}));
    EXPECT_TRUE(test::tells(error_of({verb, "out/quick", "--set", "look.colour_mop=turbo"}),
                            {"--set", "look.colour_mop=turbo", "'look.colour_mop'", "'look.colour_map'?"}));
    EXPECT_TRUE(test::tells(error_of({verb, "out/quick", "--set", "motion.amplitude=1"}),
                            {"--set", "motion.amplitude=1", "motion.amplitude", "[look]", "output.size"}));
    EXPECT_TRUE(test::tells(error_of({verb, "out/quick", "--frames", "3:1"}), {"'3:1'", "100:200", "100", ":200"}));
    EXPECT_TRUE(test::tells(error_of({verb, "out/quick", "--from", "9"}), {"out/quick", "0", "1", "0", "0.04"}));
    EXPECT_TRUE(
        test::tells(error_of({verb, "out/quick", "--range", "run", "--latest"}), {"--latest", "\"run\"", "--range"}));
  }
  EXPECT_TRUE(
      test::tells(error_of({"render", "out/quick", "--size", "161x120", "--movie", "mp4"}), {".mp4", "161", "120"}));
  EXPECT_TRUE(test::tells(error_of({"movie", "out/quick", "-o", "a.avi"}), {"a.avi", ".mp4", ".webm", ".gif"}));
  write_text(scratch / "a.gif", "mine");
  EXPECT_TRUE(test::tells(error_of({"movie", "out/quick", "-o", "a.gif"}), {"a.gif", "--overwrite"}));
  EXPECT_EQ(read_file(scratch / "a.gif"), "mine");
  EXPECT_FALSE(fs::exists(out / "render"));
}

TEST_F(Replay, WithoutVtuFilesItSaysSoButFilmsThePictures) {
  run(run_until("0.08", {"--set", "output.vtu=false"}));
  const Result result = seiche(scratch.folder(), {"render", "out/quick"});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(test::tells(result.err, {"out/quick", "output.vtu = false"}));
  run({"movie", "out/quick", "-o", "a.mp4"});
  EXPECT_EQ(facts_of(scratch / "a.mp4"), "320,240,25/1,3");
  fs::remove(out / "frames/000001.png");
  const Result gap = seiche(scratch.folder(), {"movie", "out/quick", "-o", "b.mp4"});
  EXPECT_EQ(gap.code, 2);
  EXPECT_TRUE(test::tells(gap.err, {"after out/quick/frames/000000.png", "--frames A:B"}));
}

TEST_F(Replay, LatestFollowsARunToItsEnd) {
  Program going(scratch.folder(), run_until("3"));
  ASSERT_TRUE(going.wait_for("  5 %"));
  Program pictures(scratch.folder(), {"render", "out/quick", "--latest", "-o", "latest", "--movie", "mp4"});
  Program movie(scratch.folder(), {"movie", "out/quick", "--latest", "-o", "latest.webm"});
  EXPECT_EQ(going.wait().code, 0);
  const Result drawn = pictures.wait(), filmed = movie.wait();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(filmed.code, 0) << filmed.err;
  EXPECT_EQ(pictures_in(scratch / "latest"), 76);
  EXPECT_EQ(facts_of(scratch / "latest/quick.mp4"), "320,240,25/1,76");
  EXPECT_EQ(facts_of(scratch / "latest.webm"), "320,240,25/1,76");
}

TEST_F(Replay, ASignalEndsItWithAMovieThatPlays) {
  Program going(scratch.folder(), run_until("60"));
  ASSERT_TRUE(going.wait_for("  0 %"));
  for (const std::string verb : {"render", "movie"}) {
    std::vector<std::string> arguments{verb, "out/quick", "--latest", "-o", verb == "render" ? "a" : "a/quick.webm"};
    if (verb == "render") arguments.insert(arguments.end(), {"--movie", "mp4"});
    Program latest(scratch.folder(), arguments);
    ASSERT_TRUE(latest.wait_for("frame "));
    latest.signal(SIGINT);
    const Result result = latest.wait();
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_NE(result.out.find("Interrupted: "), std::string::npos) << result.out;
  }
  going.signal(SIGINT);
  going.wait();
  const long pictures = pictures_in(scratch / "a");
  EXPECT_GE(pictures, 1);
  EXPECT_EQ(facts_of(scratch / "a/quick.mp4"), "320,240,25/1," + std::to_string(pictures));
  EXPECT_NE(facts_of(scratch / "a/quick.webm"), "");
}

}  // namespace
}  // namespace seiche::test
