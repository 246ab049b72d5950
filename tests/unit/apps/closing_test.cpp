#include "apps/closing.hpp"

#include <gtest/gtest.h>

#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;
using test::write_text;

RunRecord record_of(Ending ending) {
  RunRecord record;
  record.ending = std::move(ending);
  record.seconds["total"] = 65;
  record.statistics.steps = 100;
  record.statistics.iterations = 1250;
  return record;
}

TEST(Closing, SaysWhereEverythingThatWasWrittenIs) {
  const Scratch scratch;
  const OutputFolder folder{scratch.folder(), "x"};
  for (const char* name : {"x.mp4", "frames/000000.png", "x.pvd", "run.json"}) write_text(scratch / name, "");
  const std::string path = scratch.folder();
  EXPECT_EQ(closing_text(Scene{}, folder, record_of({Ending::Status::finished, "", 11, 1})),
            "Finished at t = 1 s: 11 frames, 100 steps, 12.5 pressure iterations a step, 1:05 of wall time\n"
            "  movie     " +
                path +
                "/x.mp4\n"
                "  pictures  " +
                path +
                "/frames/\n"
                "  ParaView  " +
                path +
                "/x.pvd\n"
                "  report    " +
                path + "/run.json\n");
}

TEST(Closing, SaysWhyARunFailed) {
  const Scratch scratch;
  const std::string text =
      closing_text(Scene{}, {scratch.folder(), "x"}, record_of({Ending::Status::failed, "it blew up", 1, 0.25}));
  EXPECT_EQ(
      text,
      "the run failed: it blew up\nKept: 1 frame, 100 steps, 12.5 pressure iterations a step, 1:05 of wall time\n");
}

TEST(Closing, WarnsOfLeaks) {
  const Scratch scratch;
  RunRecord record = record_of({});
  record.statistics.leaked = 2;
  EXPECT_NE(closing_text(Scene{}, {scratch.folder(), "x"}, record).find("warning   2 fluid particles leaked"),
            std::string::npos);
}

}  // namespace
}  // namespace seiche::apps
