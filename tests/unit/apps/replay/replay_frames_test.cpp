#include "apps/replay/replay_frames.hpp"

#include <gtest/gtest.h>

#include "tests/facts.hpp"
#include "tests/unit/apps/stored_tank.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;

constexpr const char* no_pictures = "output.pictures = false\noutput.movie = \"none\"\n";

struct ReplayFramesTest : testing::Test {
  Scratch scratch;
  StoredTank tank{scratch, no_pictures};
  StoredRun run;
  void SetUp() override {
    tank.write_frames(4);
    tank.close();
    run = read_run(tank.folder().path);
  }
};

TEST_F(ReplayFramesTest, EachHasTheReadingsSinceTheOneBefore) {
  ReplayFrames frames(run, {run, stored_frames, {}});
  std::vector<std::size_t> rows;
  while (const FramePtr frame = frames.next()) {
    const Readings& readings = frame->readings;
    rows.push_back(readings.time.size());
    ASSERT_EQ(readings.values.size(), readings.time.size() * run.info.sensors.size());
    EXPECT_NEAR(readings.time.back(), frame->time, 1e-9);
    EXPECT_NEAR(readings.values.back(),
                std::sin(31 * readings.time.back() + static_cast<double>(run.info.sensors.size() - 1)) / 30, 1e-8);
    EXPECT_EQ(frame->pose.displacement, test::lattice({}, 0, frame->index)->pose.displacement);
  }
  EXPECT_EQ(rows, (std::vector<std::size_t>{1, 20, 20, 20, 20}));
}

TEST_F(ReplayFramesTest, TheFirstOfASelectionHasAllBeforeIt) {
  Selection late;
  late.first = 3;
  ReplayFrames frames(run, {run, stored_frames, late});
  EXPECT_EQ(frames.next()->readings.time.size(), 61u);
  EXPECT_EQ(frames.next()->readings.time.size(), 20u);
}

TEST_F(ReplayFramesTest, TheFirstMayHaveAll) {
  ReplayFrames frames(run, {run, stored_frames, {}});
  frames.hand_out_all_readings();
  EXPECT_EQ(frames.next()->readings.time.size(), 81u);
  EXPECT_TRUE(frames.next()->readings.time.empty());
}

TEST_F(ReplayFramesTest, AMissingFileIsNamed) {
  const auto file = stored_frames(run)[2].file;
  std::filesystem::remove(file);
  ReplayFrames frames(run, {run, stored_frames, {}});
  frames.next();
  frames.next();
  try {
    frames.next();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(test::tells(error.what(), {file.string(), "isn't there"}));
  }
}

}  // namespace
}  // namespace seiche::apps
