#include "apps/compare/drawing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/common/csv.hpp"
#include "apps/common/output_folder.hpp"
#include "apps/compare/runs.hpp"
#include "apps/run/probes_csv.hpp"
#include "apps/run/run_info.hpp"
#include "render/curves/curve_choice.hpp"
#include "render/outputs.hpp"
#include "render/panels/compared_curves.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/refusal.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

namespace seiche::apps::compare {
namespace {

using test::refusal;
using test::Scratch;
using test::write_text;
using Status = Ending::Status;

// A run with a frame at each interval up to a time.
ComparedRun run_until(double time, double interval, Status status = Status::finished) {
  ComparedRun run;
  run.run.folder = fmt::format("run-{:.6g}", interval);
  run.run.info.frame_interval = interval;
  run.run.info.end = 10;
  run.run.record.ending = Ending{status, Failure{1.05, 7, "it leaks", "much of it"}, "", 0, time, 0};
  for (long k = 0; static_cast<double>(k) * interval < time + 1e-9; ++k)
    run.frames.push_back({k, static_cast<double>(k) * interval, "x.vtu"});
  if (run.frames.back().time < time - 1e-9) run.frames.push_back({run.frames.back().index + 1, time, "x.vtu"});
  return run;
}

TEST(Clock, RunsInTheShortestIntervalThatAllRunsHaveFramesAt) {
  EXPECT_DOUBLE_EQ(clock_of({run_until(2, 0.04), run_until(3, 0.02), run_until(1, 0.02)}).interval, 0.04);
  const Clock clock = clock_of({run_until(2, 0.04), run_until(3, 0.02), run_until(1, 0.1)});
  EXPECT_DOUBLE_EQ(clock.interval, 0.2);
  EXPECT_EQ(clock.last, 15) << "until the longest run ends";
  EXPECT_DOUBLE_EQ(clock.end, 3);
  EXPECT_DOUBLE_EQ(clock.time(7), 1.4);
}

TEST(Clock, EndsWithTheLastFrameThoughThatIsNoWholeNumberOfIntervals) {
  const Clock clock = clock_of({run_until(0.3, 0.04), run_until(0.25, 0.04)});
  EXPECT_EQ(clock.last, 8);
  EXPECT_DOUBLE_EQ(clock.end, 0.3);
  EXPECT_DOUBLE_EQ(clock.time(7), 0.28);
  EXPECT_DOUBLE_EQ(clock.time(8), 0.3);
}

TEST(Clock, RefusesRatesWithHardlyATimeInCommon) {
  const std::string what = refusal([] { clock_of({run_until(1, 1 / 24.), run_until(1, 1 / 25.)}); });
  EXPECT_TRUE(test::tells(what, {"run-0.0416667", "24", "run-0.04", "25", "output.frame_rate"}));
}

TEST(Clock, ShowsAFailureForOnePictureAtLeast) {
  EXPECT_EQ(clock_of({run_until(1, 0.1), run_until(1, 0.1, Status::failed)}).last, 11);
  const Clock clock = clock_of({run_until(1, 0.1), run_until(0.95, 0.1, Status::failed)});
  EXPECT_EQ(clock.last, 10);
  EXPECT_DOUBLE_EQ(clock.end, 1);
  EXPECT_DOUBLE_EQ(clock_of({run_until(0.5, 0.1), run_until(0.95, 0.1, Status::failed)}).end, 1) << "after its last";
}

TEST(FrameAt, IsTheLastOneUpToThen) {
  const ComparedRun run = run_until(1, 0.1);
  EXPECT_EQ(frame_at(run, 0), 0u);
  EXPECT_EQ(frame_at(run, 0.3), 3u);
  EXPECT_EQ(frame_at(run, 0.1 * 3), 3u);
  EXPECT_EQ(frame_at(run, 0.39), 3u);
  EXPECT_EQ(frame_at(run, 5), 10u);
}

TEST(Verdict, OfAFailureIsWhenAndWhy) {
  EXPECT_EQ(ending_lines({Status::failed, Failure{0.2294, 9, "61 of 1200 leaked", "more of it"}, "", 3, 0.2294, 0}),
            (std::vector<std::string>{"stopped at 0.229 s", "61 of 1200 leaked"}));
  EXPECT_EQ(ending_lines({Status::failed, {}, "can't write a: is the disk full?", 3, 0.5, 0}),
            (std::vector<std::string>{"stopped at 0.500 s", "can't write a: is the disk full?"}));
  EXPECT_EQ(ending_lines({Status::finished, {}, "", 3, 10, 0}), (std::vector<std::string>{"finished at 10 s"}));
  EXPECT_EQ(ending_lines({Status::interrupted, {}, "", 3, 0.5, 0}),
            (std::vector<std::string>{"interrupted at 0.500 s"}));
}

TEST(Variant, SaysWhyItsFramesEnd) {
  EXPECT_EQ(variant_of(run_until(1, 0.1, Status::failed), 10).message,
            (std::vector<std::string>{"stopped at 1.000 s", "it leaks"}));
  EXPECT_EQ(variant_of(run_until(2, 0.1), 10).message, (std::vector<std::string>{"ends at 2 s"}));
  EXPECT_TRUE(variant_of(run_until(10, 0.1), 10).message.empty());
  ComparedRun killed = run_until(1.2, 0.1);
  killed.run.record.ending.reset();
  EXPECT_EQ(variant_of(killed, 10).message, (std::vector<std::string>{"unfinished: ends at 1.2 s"}));
  EXPECT_FALSE(variant_of(killed, 10).failed);
}

TEST(Variant, TellsOfLostParticles) {
  ComparedRun run = run_until(1, 0.1);
  run.label = "KF5";
  EXPECT_EQ(variant_of(run, 1).label, "KF5");
  run.run.record.statistics.leaked = 7;
  EXPECT_EQ(variant_of(run, 1).label, "KF5, 7 leaked");
  run.run.record.statistics.spilled = 12;
  EXPECT_EQ(variant_of(run, 1).label, "KF5, 7 leaked, 12 spilled");
}

// A run of the synthetic tank in a folder, read back.
ComparedRun stored(const Scratch& scratch) {
  const std::filesystem::path folder = scratch / "run";
  Scene scene;
  scene.name = "tank";
  scene.parameters.time.end = 0.2;
  const RunInfo info = run_info(scene);
  RunRecord record;
  record.ending = Ending{Status::finished, {}, "", 3, 0.04, 0};
  write_run_json(folder / "run.json", scene, record);
  const auto vtu = render::vtu_series(folder);
  const auto probes = probes_csv(folder / "probes.csv");
  for (const auto& sink : {vtu.get(), probes.get()}) sink->begin(info);
  for (long k = 0; k < 3; ++k) {
    Frame frame = *test::lattice({.spacing = 0.02}, 0.1, k);
    for (int row = 0; row < 20; ++row) {
      const double time = 0.02 * static_cast<double>(k) + 0.001 * row;
      frame.readings.time.push_back(time);
      for (std::size_t c = 0; c < info.sensors.size(); ++c)
        frame.readings.values.push_back(std::sin(50 * time) + static_cast<double>(c));
    }
    const auto shared = std::make_shared<const Frame>(frame);
    for (const auto& sink : {vtu.get(), probes.get()}) sink->frame(shared);
  }
  for (const auto& sink : {vtu.get(), probes.get()}) sink->end();
  return compared("tank", read_run(folder));
}

TEST(Compared, ItsCurvesAtTheMarkEqualTheCsv) {
  const Scratch scratch;
  const ComparedRun run = stored(scratch);
  render::Look look;
  look.curves = render::parse_curves("eta_left, force_x");
  auto curves = render::compared_curves({variant_of(run, 0.04)}, look);
  for (auto& curve : curves) render::record(curve, run.readings);
  render::settle(curves);
  const Csv csv = read_csv(scratch / "run/probes.csv", "probes");
  for (std::size_t row = 0; row < csv.rows(); ++row)
    for (const auto& curve : curves) {
      const auto at = render::latest(curve.traces[0], csv.number(row, 0));
      ASSERT_TRUE(at);
      EXPECT_EQ((*at)[0], csv.number(row, 0));
      EXPECT_EQ((*at)[1], csv.number(row, 1 + curve.traces[0].column)) << row;
    }
}

TEST(Compared, ARunWithoutFramesIsRefused) {
  const Scratch scratch;
  const ComparedRun run = stored(scratch);
  const auto again = [&] { compared("tank", read_run(run.run.folder)); };
  EXPECT_EQ(refusal(again), "");
  const auto probes = scratch / "run/probes.csv";
  std::string text = test::read_file(probes);
  std::filesystem::rename(probes, scratch / "probes.csv");
  EXPECT_TRUE(test::tells(refusal(again), {probes.string(), "no readings", "0.04 s", "run it again"}));
  write_text(probes, text.substr(0, text.find("0.010000")));
  EXPECT_TRUE(test::tells(refusal(again), {probes.string(), "0.009 s", "0.04 s", "run it again"}));
  write_text(probes, text);
  EXPECT_EQ(refusal(again), "");
  std::filesystem::remove(run.frames[1].file);
  EXPECT_TRUE(test::tells(refusal(again), {run.frames[1].file.string()}));
  std::filesystem::remove(run.run.folder / "tank.vtu.series");
  EXPECT_TRUE(test::tells(refusal(again), {run.run.folder.string(), "output.vtu = true"}));
}

}  // namespace
}  // namespace seiche::apps::compare
