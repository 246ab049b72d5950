#include "apps/compare/folder.hpp"

#include <gtest/gtest.h>

#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/refusal.hpp"

namespace fs = std::filesystem;

namespace seiche::apps::compare {
namespace {

using test::refusal;
using test::Scratch;
using test::write_text;

std::vector<ShownRun> shown(const Scratch& scratch, const std::vector<std::string>& folders) {
  std::vector<ShownRun> all;
  for (const std::string& each : folders) all.push_back({each, scratch / each});
  return all;
}

TEST(CheckFolder, TakesOneThatIsEmptyOrNotThere) {
  const Scratch scratch;
  EXPECT_EQ(refusal([&] { check_folder(scratch / "c", shown(scratch, {"A", "B"}), false); }), "");
  fs::create_directories(scratch / "c");
  EXPECT_EQ(refusal([&] { check_folder(scratch / "c", shown(scratch, {"A", "B"}), false); }), "");
}

TEST(CheckFolder, TakesTheSameComparisonOrALargerOneAgainButNoOther) {
  const Scratch scratch;
  const fs::path folder = scratch / "c";
  write_note(folder, shown(scratch, {"A", "c/KF1"}));
  const auto asked = [&](const std::vector<std::string>& folders, bool overwrite = false) {
    return refusal([&] { check_folder(folder, shown(scratch, folders), overwrite); });
  };
  EXPECT_EQ(asked({"c/KF1", "A"}), "");
  EXPECT_EQ(asked({"c/../A", "B", "c/KF1"}), "");
  const auto is_complaint = [&](const std::string& text) {
    return test::tells(text, {folder.string(), "../A, KF1", "-o DIR", "--overwrite"});
  };
  EXPECT_EQ(asked({"A", "B"}), "") << "nothing of it has been drawn";
  write_text(folder / "frames/000000.png", "drawn");
  EXPECT_EQ(asked({"c/KF1", "A"}), "");
  EXPECT_TRUE(is_complaint(asked({"A", "B"})));
  EXPECT_TRUE(is_complaint(asked({"A"})));
  EXPECT_EQ(asked({"A", "B"}, true), "");
  write_text(folder / "compare.json", "{");
  EXPECT_TRUE(test::tells(asked({"A"}), {(folder / "compare.json").string(), "-o DIR", "--overwrite"}));
  write_text(folder / "compare.json", R"({"seiche": "0.1.0", "runs": []})");
  EXPECT_TRUE(test::tells(
      asked({"A"}), {(folder / "compare.json").string(), "schema version", "version 1", "-o DIR", "--overwrite"}));
}

TEST(FolderLock, IsHeldByOneAtATime) {
  const Scratch scratch;
  const fs::path folder = scratch / "new/folder";
  const auto lock = [&] { FolderLock another(folder); };
  {
    const FolderLock first(folder);
    EXPECT_TRUE(test::tells(refusal(lock), {"`seiche compare`", folder.string(), "-o DIR"}));
  }
  EXPECT_EQ(refusal(lock), "");
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(FolderLock, IsNoneWhereAFileIsInTheWay) {
  const Scratch scratch;
  write_text(scratch / "file", "mine");
  const fs::path file = scratch / "file", below = file / "below";
  EXPECT_TRUE(test::tells(refusal([&] { FolderLock lock(file); }), {file.string(), "is a file", "-o DIR"}));
  EXPECT_TRUE(test::tells(refusal([&] { FolderLock lock(below); }), {below.string(), "Not a directory"}));
}

TEST(Draft, ReplacesWhatWasThereOnlyWhenItIsPublished) {
  const Scratch scratch;
  const OutputFolder files = files_in(scratch.folder());
  write_text(files.movie(render::MovieFormat::gif), "old");
  write_text(files.frames() / "000007.png", "old");
  write_text(files.frames() / "notes.txt", "mine");
  write_text(scratch / "KF1/run.json", "{}");
  const auto draw = [](const Draft& draft) {
    write_text(draft.files().movie(render::MovieFormat::mp4), "new");
    write_text(draft.files().frames() / "000000.png", "new");
  };
  const auto left = [&] { return std::distance(fs::directory_iterator(scratch.folder()), fs::directory_iterator()); };
  {
    Draft draft(scratch.folder());
    draw(draft);
  }
  EXPECT_EQ(test::read_file(files.movie(render::MovieFormat::gif)), "old");
  EXPECT_EQ(left(), 3) << "no trace of it";
  {
    Draft draft(scratch.folder());
    draw(draft);
    draft.publish();
  }
  EXPECT_EQ(test::read_file(files.movie(render::MovieFormat::mp4)), "new");
  EXPECT_EQ(test::read_file(files.frames() / "000000.png"), "new");
  EXPECT_FALSE(fs::exists(files.movie(render::MovieFormat::gif)));
  EXPECT_FALSE(fs::exists(files.frames() / "000007.png"));
  EXPECT_TRUE(fs::exists(files.frames() / "notes.txt"));
  EXPECT_TRUE(fs::exists(scratch / "KF1/run.json"));
  EXPECT_EQ(left(), 3);
}

}  // namespace
}  // namespace seiche::apps::compare
