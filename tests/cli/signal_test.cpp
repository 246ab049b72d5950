// Runs that are cut short, by Ctrl-C and by force.
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

const std::string quick = SEICHE_SCENES "/quick.toml";

// Twenty seconds of the quick scene with small pictures; every 5 % are 1 s and 25 frames.
const std::vector<std::string> long_run{"run", quick, "--end", "20", "--set", "output.size=160x120"};

nlohmann::json report_in(const fs::path& folder) {
  return nlohmann::json::parse(read_file(folder / "out/quick/run.json"));
}

long count(const std::string& text, const std::string& part) {
  long found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

int frames_in(const fs::path& movie) {
  return std::atoi(output_of("ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 '" +
                             movie.string() + "'")
                       .c_str());
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, FinishesTheFrameAndClosesEverything) {
  const Scratch scratch;
  Program program(scratch.folder(), long_run);
  ASSERT_TRUE(program.wait_for("  5 %"));
  program.signal(GetParam());
  const Result result = program.wait();
  EXPECT_EQ(result.code, 130) << result.err;
  EXPECT_NE(result.out.find("Interrupted at t = "), std::string::npos) << result.out;

  const nlohmann::json run = report_in(scratch.folder())["run"];
  EXPECT_EQ(run["status"], "interrupted");
  const long frames = run["frames"];
  EXPECT_GE(frames, 25);
  EXPECT_EQ(frames_in(scratch / "out/quick/quick.mp4"), frames);
  const std::string pvd = read_file(scratch / "out/quick/quick.pvd");
  EXPECT_EQ(count(pvd, "<DataSet "), frames);
  EXPECT_NE(pvd.find("</VTKFile>"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(By, Interrupt, testing::Values(SIGINT, SIGTERM));

TEST(Signals, ASecondOneEndsTheRunAtOnce) {
  const Scratch scratch;
  std::vector<std::string> one_frame = long_run;
  one_frame.insert(one_frame.end(), {"--end", "1000", "--set", "output.frame_rate=0.001"});
  Program program(scratch.folder(), one_frame);
  ASSERT_TRUE(program.wait_for("  0 %"));
  program.signal(SIGINT);
  ASSERT_TRUE(program.wait_for("ending with this frame"));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().code, 130);
  EXPECT_EQ(report_in(scratch.folder())["run"]["status"], "running");
}

TEST(Signals, AfterAKillTheMovieStillPlays) {
  // The encoder outlives the program; as its new parent this test can wait for its end.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const Scratch scratch;
  Program program(scratch.folder(), long_run);
  ASSERT_TRUE(program.wait_for(" 10 %"));
  program.signal(SIGKILL);
  EXPECT_EQ(program.wait().code, 128 + SIGKILL);
  while (waitpid(-1, nullptr, 0) > 0) continue;

  EXPECT_GE(frames_in(scratch / "out/quick/quick.mp4"), 25);
  const std::string pvd = read_file(scratch / "out/quick/quick.pvd");
  EXPECT_NE(pvd.find("</VTKFile>"), std::string::npos);
  EXPECT_EQ(report_in(scratch.folder())["run"]["status"], "running");
}

TEST(Signals, AnInterruptedValidationKeepsWhatItFound) {
  const Scratch scratch;
  Program program(scratch.folder(), {"validate", "--quick", "--only", "still-tank"});
  ASSERT_TRUE(program.wait_for("still-tank: "));
  program.signal(SIGINT);
  const Result result = program.wait();
  EXPECT_EQ(result.code, 130) << result.err;
  EXPECT_NE(result.out.find("Interrupted. 0 figures"), std::string::npos) << result.out;
  EXPECT_TRUE(fs::exists(scratch / "out/validate/table.md"));
}

}  // namespace
}  // namespace seiche::test
