#include "apps/run/summary.hpp"

#include <gtest/gtest.h>

#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;
using test::write_text;

RunRecord record_of(Ending ending) {
  RunRecord record;
  record.ending = std::move(ending);
  record.times.total = 65;
  record.statistics.steps = 100;
  record.statistics.iterations = 1250;
  record.statistics.fluid_particles = 4800;
  return record;
}

TEST(Summary, SaysWhereEverythingThatWasWrittenIs) {
  const Scratch scratch;
  const OutputFolder folder{scratch.folder(), "x"};
  for (const char* name : {"x.mp4", "frames/000000.png", "x.pvd", "run.json", "report.html"})
    write_text(scratch / name, "");
  const std::string path = scratch.folder();
  RunRecord record = record_of({Ending::Status::finished, {}, "", 11, 1});
  record.times = {{{"solve", 0.6}, {"search", 0.35}, {"shift", 0.05}}, {{"vtu", 1.26}, {"pictures", 25.4}}, 0.65, 65};
  EXPECT_EQ(summary_text(Scene{}, folder, record),
            "Finished at t = 1 s: 11 frames, 100 steps, 12.5 pressure iterations a step, 1:05 of wall time\n"
            "  speed     480,000 particle-steps a second: solve 60 %, search 35 %, other 5 %\n"
            "  outputs   pictures 25 s, vtu 1.3 s, beside the steps; held the run up for 0.7 s (1 %)\n"
            "  pictures  " +
                path + "/frames/\n  movie     " + path + "/x.mp4\n  ParaView  " + path + "/x.pvd\n  report    " + path +
                "/report.html\n  record    " + path + "/run.json\n");
}

TEST(Summary, SaysWhyARunFailed) {
  const Scratch scratch;
  RunRecord record = record_of({Ending::Status::failed, {}, "it blew up", 1, 0.25});
  record.statistics.steps = 0;
  EXPECT_EQ(summary_text(Scene{}, {scratch.folder(), "x"}, record),
            "the run failed: it blew up\nKept: 1 frame, 0 steps, 0.0 pressure iterations a step, 1:05 of wall time\n");
}

TEST(Summary, WarnsOfLeaks) {
  const Scratch scratch;
  RunRecord record = record_of({});
  record.statistics.leaked = 2;
  EXPECT_NE(summary_text(Scene{}, {scratch.folder(), "x"}, record).find("warning   2 fluid particles leaked"),
            std::string::npos);
}

}  // namespace
}  // namespace seiche::apps
