#include "apps/run/probes_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "apps/scene/scene.hpp"
#include "solver/simulation.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

using test::read_file;
using test::Scratch;

FramePtr frame_with(Readings readings) {
  auto frame = std::make_shared<Frame>();
  frame->readings = std::move(readings);
  return frame;
}

TEST(ProbesCsv, HasUnitsInItsHeaderAndARowForEachReading) {
  const Scratch folder;
  const auto csv = probes_csv(folder / "probes.csv");
  RunInfo run;
  run.sensors = {{"p_left_bottom", "Pa", ""}, {"eta_left", "m", ""}, {"eta_right", "m", ""}};
  csv->begin(run);
  csv->frame(frame_with({}));
  csv->frame(frame_with({{0, 0.001}, {1962, 0, -1e-9, 1234.56789, 0.0123456789, -0.5}}));
  const std::string expected =
      "t [s],p_left_bottom [Pa],eta_left [m],eta_right [m]\n"
      "0.000000,1962,0,-1e-09\n"
      "0.001000,1234.568,0.01234568,-0.5\n";
  EXPECT_EQ(read_file(folder / "probes.csv"), expected) << "not on the disk after the frame";
  csv->end();
  EXPECT_EQ(read_file(folder / "probes.csv"), expected);
}

TEST(ProbesCsv, LeavesAGapEmpty) {
  const Scratch folder;
  const auto csv = probes_csv(folder / "probes.csv");
  RunInfo run;
  run.sensors = {{"volume", "m^2", ""}, {"eta_left", "m", ""}};
  csv->begin(run);
  csv->frame(frame_with({{0}, {std::numeric_limits<double>::quiet_NaN(), 0.5}}));
  EXPECT_EQ(read_file(folder / "probes.csv"), "t [s],volume [m^2],eta_left [m]\n0.000000,,0.5\n");
}

TEST(ProbesCsv, SaysWhenTheFileCannotBeWritten) {
  const Scratch folder;
  EXPECT_THROW(probes_csv(folder / "missing/probes.csv")->begin({}), std::runtime_error);
}

}  // namespace
}  // namespace seiche::apps
