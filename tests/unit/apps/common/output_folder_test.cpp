#include "apps/common/output_folder.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

using test::Scratch;
using test::write_text;

TEST(OutputFolder, TakesAMissingOrEmptyOne) {
  const Scratch scratch;
  OutputFolder{scratch / "new/deep", "x"}.check(false);
  OutputFolder{scratch.folder(), "x"}.check(false);
  EXPECT_FALSE(fs::exists(scratch / "new"));
}

TEST(OutputFolder, RefusesOneWithFilesUnlessTheyMayBeOverwritten) {
  const Scratch scratch;
  write_text(scratch / "notes.txt", "mine");
  const OutputFolder folder{scratch.folder(), "x"};
  EXPECT_THROW(folder.check(false), BadFolder);
  EXPECT_NO_THROW(folder.check(true));
}

TEST(OutputFolder, RefusesAFile) {
  const Scratch scratch;
  write_text(scratch / "file", "mine");
  EXPECT_THROW((OutputFolder{scratch / "file", "x"}.check(true)), BadFolder);
}

TEST(OutputFolder, EachKindOfOutputHasItsRow) {
  ASSERT_EQ(output_rows().size(), output_kinds);
  for (std::size_t k = 0; k < output_kinds; ++k) EXPECT_EQ(output_rows()[k].kind, static_cast<OutputKind>(k));
}

TEST(OutputFolder, KnowsWhereAKindIs) {
  const Scratch scratch;
  const OutputFolder folder{scratch.folder(), "x"};
  EXPECT_EQ(folder.place(OutputKind::movie), "");
  write_text(scratch / "x.gif", "");
  write_text(scratch / "frames/000000.png", "");
  EXPECT_EQ(folder.place(OutputKind::movie), scratch / "x.gif");
  EXPECT_EQ(folder.place(OutputKind::pictures), scratch / "frames" / "");
}

TEST(OutputFolder, OverwritingTakesOutARunAndNothingElse) {
  const Scratch scratch;
  for (const char* ours : {"frames/000000.png", "frames/.part-000001.png", "vtu/x_000000.vtu", "x.mp4", ".part-x.mp4",
                           "x.gif", "x.webm", "x.pvd", "x.vtu.series", "probes.csv", "run.json", "report.html"}) {
    write_text(scratch / ours, "ours");
  }
  const std::vector<std::string> theirs{"notes.txt",        "y.mp4",          "frames/best.png",
                                        "vtu/y_000000.vtu", "vtu/x_mean.vtu", "x.toml"};
  for (const std::string& name : theirs) write_text(scratch / name, "theirs");

  OutputFolder{scratch.folder(), "x"}.prepare();

  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.folder())) {
    if (entry.is_regular_file()) left.push_back(fs::relative(entry.path(), scratch.folder()));
  }
  EXPECT_EQ(std::set(left.begin(), left.end()), std::set(theirs.begin(), theirs.end()));
}

}  // namespace
}  // namespace seiche::apps
