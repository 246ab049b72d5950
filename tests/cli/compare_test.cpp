// Comparisons of small scenes: what they run, write and say.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

const std::string quick = SEICHE_SCENES "/quick.toml";

std::vector<std::string> compare(std::vector<std::string> more) {
  std::vector<std::string> all{"compare", quick,    "--vary", "method.kernel=KF2,KF3", "--set", "preset=paper", "--end",
                               "0.2",     "--size", "640x360"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

nlohmann::json report_in(const fs::path& folder) { return nlohmann::json::parse(read_file(folder / "run.json")); }

long files_in(const fs::path& folder) {
  return fs::exists(folder) ? std::distance(fs::directory_iterator(folder), fs::directory_iterator()) : 0;
}

std::string movie_of(const fs::path& file) {
  return output_of("ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames -of csv=p=0 " +
                   file.string());
}

TEST(Compare, TwoKernelsEndInOneMovieThoughOneFails) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), compare({}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("KF2    stopped at 0."), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("KF3    finished at 0.2 s\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("  movie     out/quick-compare/compare.mp4\n"), std::string::npos) << result.out;
  const fs::path out = scratch / "out/quick-compare";
  EXPECT_EQ(movie_of(out / "compare.mp4"), "640,360,6\n");
  EXPECT_EQ(files_in(out / "frames"), 6);
  const std::string page = read_file(out / "report.html");
  for (const char* text : {"<html", "KF2", "KF3", "</html>"}) EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_FALSE(fs::exists(out / "KF3/report.html"));
  EXPECT_EQ(report_in(out / "KF2")["run"]["status"], "failed");
  EXPECT_EQ(report_in(out / "KF3")["run"]["status"], "finished");
  EXPECT_EQ(files_in(out / "KF3/vtu"), 6);
  EXPECT_FALSE(fs::exists(out / "KF3/frames"));
  EXPECT_FALSE(fs::exists(out / "KF3/quick.mp4"));
}

TEST(Compare, WhatIsDoneIsNotRunAgainUnlessAskedTo) {
  const Scratch scratch;
  ASSERT_EQ(seiche(scratch.folder(), compare({"--quiet"})).code, 0);
  const fs::path out = scratch / "out/quick-compare", report = out / "KF3/run.json";
  const std::string before = read_file(report);
  write_text(out / "notes.txt", "mine");

  const Result again = seiche(scratch.folder(), compare({"--range", "frame", "--movie", "gif"}));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("KF3    finished at 0.2 s; done before\n"), std::string::npos) << again.out;
  EXPECT_EQ(read_file(report), before);
  EXPECT_TRUE(fs::exists(out / "compare.gif"));
  EXPECT_FALSE(fs::exists(out / "compare.mp4"));
  EXPECT_EQ(read_file(out / "notes.txt"), "mine");

  const Result other = seiche(scratch.folder(), compare({"--end", "0.12"}));
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.out, "");
  EXPECT_TRUE(test::tells(other.err, {"out/quick-compare/KF2", "time.end = 0.2", "0.12", "-o DIR", "--overwrite"}));
  EXPECT_EQ(read_file(report), before);
  EXPECT_TRUE(fs::exists(out / "compare.gif"));

  const Result asked = seiche(scratch.folder(), compare({"--end", "0.12", "--overwrite"}));
  EXPECT_EQ(asked.code, 0) << asked.err;
  EXPECT_EQ(asked.out.find("done before"), std::string::npos) << asked.out;
  EXPECT_EQ(files_in(out / "frames"), 4);
}

// A comparison and all that is in its folder but the variants' own data, as text.
std::string shown_in(const fs::path& folder) {
  std::string all;
  for (const char* file : {"compare.json", "compare.mp4", "report.html", "frames/000000.png", "frames/000005.png"})
    all += read_file(folder / file);
  return all + std::to_string(files_in(folder)) + " " + std::to_string(files_in(folder / "frames"));
}

TEST(Compare, AComparisonOfOtherRunsIsNotReplacedUnlessAskedTo) {
  const Scratch scratch;
  ASSERT_EQ(seiche(scratch.folder(), compare({"-o", "a", "--quiet"})).code, 0);
  ASSERT_EQ(seiche(scratch.folder(), compare({"-o", "b", "--quiet"})).code, 0);
  const std::string before = shown_in(scratch / "a");
  const std::vector<std::string> others{"compare", "a/KF2", "b/KF3", "-o", "a", "--size", "640x360", "--quiet"};
  const Result refused = seiche(scratch.folder(), others);
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(test::tells(refused.err, {"seiche: a ", "KF2, KF3", "-o DIR", "--overwrite"}));
  EXPECT_EQ(seiche(scratch.folder(), {"compare", quick, "--vary", "method.kernel=KF1,KF4", "-o", "a"}).code, 2);
  EXPECT_TRUE(shown_in(scratch / "a") == before);
  auto asked = others;
  asked.emplace_back("--overwrite");
  EXPECT_EQ(seiche(scratch.folder(), asked).code, 0);
  EXPECT_FALSE(shown_in(scratch / "a") == before);
  EXPECT_EQ(seiche(scratch.folder(), others).code, 0) << "now it is the same";
}

TEST(Compare, AnEarlierComparisonStaysUntilTheNewOneIsWhole) {
  const Scratch scratch;
  // Many pictures, so that a signal comes before the last.
  const std::vector<std::string> few{"-o", "out", "--set", "output.frame_rate=500"};
  auto many = few;
  many.insert(many.end(), {"--range", "frame"});
  ASSERT_EQ(seiche(scratch.folder(), compare(few)).code, 0);
  const fs::path out = scratch / "out";
  const std::string before = shown_in(out);
  const auto interrupt = [&] {
    Program program(scratch.folder(), compare(many));
    EXPECT_TRUE(program.wait_for("pictures  [#-"));
    program.signal(SIGINT);
    return program.wait();
  };
  const Result kept = interrupt();
  EXPECT_EQ(kept.code, 130) << kept.err;
  EXPECT_NE(kept.out.find("; the earlier movie and pictures are kept\n"), std::string::npos) << kept.out;
  EXPECT_TRUE(shown_in(out) == before);

  const std::string vtu = read_file(out / "KF3/vtu/quick_000050.vtu");
  write_text(out / "KF3/vtu/quick_000050.vtu", vtu.substr(0, vtu.size() / 2));
  const Result failed = seiche(scratch.folder(), compare(few));
  EXPECT_EQ(failed.code, 1) << failed.err;
  EXPECT_TRUE(shown_in(out) == before);
  fs::copy(out / "KF2", scratch / "other", fs::copy_options::recursive);
  EXPECT_EQ(seiche(scratch.folder(), {"compare", "out/KF3", "other", "-o", "out", "--overwrite"}).code, 1);
  EXPECT_TRUE(shown_in(out) == before) << "its note too";

  write_text(out / "KF3/vtu/quick_000050.vtu", vtu);
  for (const char* gone : {"compare.mp4", "report.html", "frames"}) fs::remove_all(out / gone);
  const Result part = interrupt();
  EXPECT_EQ(part.code, 130) << part.err;
  const long pictures = files_in(out / "frames");
  EXPECT_GT(pictures, 0);
  EXPECT_LT(pictures, 100);
  EXPECT_EQ(movie_of(out / "compare.mp4"), "640,360," + std::to_string(pictures) + "\n");
}

TEST(Compare, TwoAtOnceInAFolderAreOneTooMany) {
  const Scratch scratch;
  fs::create_directory(scratch / "out");
  const int held = open((scratch / "out").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  const Result result = seiche(scratch.folder(), compare({"-o", "out"}));
  close(held);
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(test::tells(result.err, {"`seiche compare`", "in out", "-o DIR"}));
  EXPECT_EQ(files_in(scratch / "out"), 0);
}

TEST(Compare, FoldersOfRunsOfDifferentLengths) {
  const Scratch scratch;
  for (const auto& [folder, end] : {std::pair{"long", "0.2"}, {"short", "0.08"}})
    ASSERT_EQ(seiche(scratch.folder(), {"run", quick, "--end", end, "-o", folder, "--quiet", "--set",
                                        "output.pictures=false", "--set", "output.movie=none"})
                  .code,
              0);
  const std::string before = read_file(scratch / "short/run.json");
  const Result result =
      seiche(scratch.folder(), {"compare", "long", "short", "--size", "640x360", "-o", "both", "--quiet"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(movie_of(scratch / "both/compare.mp4"), "640,360,6\n");
  EXPECT_EQ(read_file(scratch / "short/run.json"), before);
}

TEST(Compare, TwiceTheSameGivesTheSamePictures) {
  const Scratch scratch;
  for (const char* folder : {"one", "two"})
    ASSERT_EQ(seiche(scratch.folder(), compare({"--quiet", "--end", "0.08", "-o", folder})).code, 0);
  for (const char* file : {"compare.mp4", "compare.json", "frames/000001.png"})
    EXPECT_TRUE(read_file(scratch / "one" / file) == read_file(scratch / "two" / file)) << file;
}

TEST(Compare, BadInputIsRefusedBeforeAnythingIsRunOrWritten) {
  const Scratch scratch;
  const auto error_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "compare");
    const Result result = seiche(scratch.folder(), arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(fs::exists(scratch / "out"));
    return result.err;
  };
  EXPECT_TRUE(test::tells(error_of({}), {"scene", "--vary", "folders"}));
  EXPECT_TRUE(test::tells(error_of({quick}), {"--vary", "KEY=VALUE,VALUE", "--vary", "method.kernel=KF1,KF3"}));
  EXPECT_TRUE(test::tells(error_of({quick, "--vary", "method.kernl=KF1"}),
                          {"--vary", "method.kernl=KF1", "'method.kernl'", "'method.kernel'?"}));
  EXPECT_TRUE(
      test::tells(error_of({quick, "--vary", "method.kernel=KF1,KF9"}),
                  {"--vary", "method.kernel=KF9", "[method]", "kernel", "'KF9'", "KF1", "KF2", "KF3", "KF4", "KF5"}));
  EXPECT_TRUE(
      test::tells(error_of({quick, "--vary", "method.kernel=KF1,KF2,KF3,KF4,KF5", "--vary", "preset=paper,stabilised"}),
                  {"10", "9"}));
  EXPECT_TRUE(
      test::tells(error_of({quick, "--vary", "method.kernel=KF1", "--size", "641x360"}), {".mp4", "641", "360"}));
  EXPECT_TRUE(test::tells(error_of({quick, "--vary", "tank.width=0,0.2"}),
                          {"--vary", "tank.width=0", "tank.width=0.2", "2-D", "3-D"}));
  EXPECT_TRUE(test::tells(error_of({"nowhere", "else"}), {"nowhere", "--vary", "folders"}));
  fs::create_directory(scratch / "empty");
  EXPECT_TRUE(test::tells(error_of({"empty"}), {"empty", "two", "--vary"}));
  EXPECT_TRUE(test::tells(error_of({"empty", "empty/"}), {"empty", "empty/", "same"}));
  EXPECT_TRUE(test::tells(error_of({"empty", "other"}), {"empty", "`seiche run`"}));
  write_text(scratch / "half/run.json", "{\"seiche\":");
  EXPECT_TRUE(test::tells(error_of({"half", "empty"}), {"half/run.json"}));
  EXPECT_TRUE(test::tells(error_of({quick, "--vary", "method.kernel=KF1", "-o", "half"}), {"half", "run", "-o DIR"}));
  write_text(scratch / "mine/notes.txt", "mine");
  EXPECT_TRUE(
      test::tells(error_of({quick, "--vary", "method.kernel=KF1", "-o", "mine"}), {"mine", "-o DIR", "--overwrite"}));
  EXPECT_EQ(files_in(scratch / "mine"), 1);
}

TEST(Compare, AVariantThatCannotBeRunIsToldAndTheOthersAreShown) {
  const Scratch scratch;
  write_text(scratch / "out/KF2", "a file where its folder should be");
  const Result result = seiche(scratch.folder(), compare({"-o", "out", "--overwrite"}));
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(test::tells(result.err, {"KF2", "out/KF2", "-o DIR"}));
  EXPECT_EQ(movie_of(scratch / "out/compare.mp4"), "640,360,6\n");
}

TEST(Compare, CtrlCEndsAllVariantsCleanly) {
  const Scratch scratch;
  Program program(scratch.folder(), {"compare", quick, "--vary", "method.kernel=KF1,KF3,KF4", "--end", "40",
                                     "--threads", "2", "--size", "640x360"});
  ASSERT_TRUE(program.wait_for("KF1    [#"));
  program.signal(SIGINT);
  const Result result = program.wait();
  EXPECT_EQ(result.code, 130) << result.err;
  EXPECT_NE(result.out.find("Interrupted after "), std::string::npos) << result.out;
  const fs::path out = scratch / "out/quick-compare";
  const nlohmann::json run = report_in(out / "KF1")["run"];
  EXPECT_EQ(run["status"], "interrupted");
  EXPECT_EQ(files_in(out / "KF1/vtu"), run["frames"]);
  EXPECT_FALSE(fs::exists(out / "compare.mp4"));
}

}  // namespace
}  // namespace seiche::test
