#include "apps/report/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/panels/deviation.hpp"
#include "tests/unit/apps/report/synthetic.hpp"

namespace seiche::apps::report {
namespace {

using std::numbers::pi;

double wave(double t) { return 0.01 * std::sin(2 * pi * t); }

TEST(ReportMeasures, NoiseIsWhatLiesAboveTenHertz) {
  const auto pressure = [](double t) { return 300 * std::sin(2 * pi * t) + 19.62 * std::sin(2 * pi * 100 * t); };
  const ReportRun run = test::report_run("a", 4, {wave, pressure});
  const Measures measures = measures_of(run, measured_sensors(run.run), {});
  ASSERT_TRUE(measures.noise);
  EXPECT_NEAR(measures.noise->value, 0.01 / std::sqrt(2), 1e-4) << "of rho g h";
  EXPECT_EQ(measures.noise->from, 0.5);
  EXPECT_EQ(measures.noise->to, 3);
}

TEST(ReportMeasures, AShortRunIsMeasuredWhole) {
  const ReportRun run = test::report_run("a", 0.4);
  const Measures measures = measures_of(run, measured_sensors(run.run), {});
  ASSERT_TRUE(measures.noise);
  EXPECT_EQ(measures.noise->from, 0);
  EXPECT_EQ(measures.noise->to, 0.4);
  const ReportRun tiny = test::report_run("a", 0.02);
  EXPECT_FALSE(measures_of(tiny, measured_sensors(tiny.run), {}).noise) << "21 readings tell nothing of 10 Hz";
}

TEST(ReportMeasures, ErrorIsThatOfThePicturesWhereBothAre) {
  ReportRun run = test::report_run("a", 3, {[](double t) { return 1.1 * wave(t); }, [](double) { return 0.0; }});
  test::add_reference(run, "theory", wave, 2);
  const Measures measures = measures_of(run, measured_sensors(run.run), run.run.scene.look.references);
  ASSERT_EQ(measures.errors.size(), 1u);
  ASSERT_TRUE(measures.errors[0]);
  EXPECT_NEAR(measures.errors[0]->rms, 0.1 * 0.01 / std::sqrt(2), 1e-5);
  EXPECT_NEAR(measures.errors[0]->of_rest, 0.1, 1e-3);
  const render::Series elevation = column_of(run.readings, run.run.info, "eta_left");
  EXPECT_EQ(measures.errors[0]->rms, render::deviation(elevation, run.run.scene.look.references[0].series, 3));
  run.readings = {};
  EXPECT_FALSE(measures_of(run, measured_sensors(run.run), run.run.scene.look.references).errors[0]);
}

TEST(ReportMeasures, CrestsAreFoundNearThoseOfTheReference) {
  // 20 ms late, and with a spike far from any crest.
  ReportRun run = test::report_run(
      "a", 2.4, {[](double t) { return wave(t - 0.02) + (t == 0.6 ? 1 : 0); }, [](double) { return 0.0; }});
  test::add_reference(run, "theory", wave, 3);
  const Measures measures = measures_of(run, measured_sensors(run.run), run.run.scene.look.references);
  ASSERT_EQ(measures.crests.size(), 2u) << "the run ends a quarter period after the third, or sooner";
  EXPECT_NEAR(measures.crests[0].time, 0.27, 1e-3);
  EXPECT_NEAR(measures.crests[0].height, 0.01, 1e-6);
  EXPECT_NEAR(measures.crests[1].time, 1.27, 1e-3);
}

TEST(ReportMeasures, CrestsOfARunAloneIgnoreSmallWaves) {
  const ReportRun run = test::report_run("a", 3.5);
  const Measures measures = measures_of(run, measured_sensors(run.run), {});
  ASSERT_EQ(measures.crests.size(), 3u);
  EXPECT_NEAR(measures.crests[2].time, 2.25, 1e-3);
  const ReportRun still =
      test::report_run("a", 3, {[](double t) { return 0.1 * wave(t); }, [](double) { return 0.0; }});
  EXPECT_TRUE(measures_of(still, measured_sensors(still.run), {}).crests.empty()) << "1 mm is below 1 % of the depth";
}

TEST(ReportMeasures, DriftComparesTheLastTenthWithTheFirst) {
  ReportRun run = test::report_run("a", 1);
  const std::size_t width = run.run.info.sensors.size(), rows = run.readings.time.size();
  const std::size_t column = find_column(run.run.info.sensors, "volume");
  for (std::size_t row = rows / 2; row < rows; ++row) run.readings.values[row * width + column] *= 1.02;
  const Measures measures = measures_of(run, measured_sensors(run.run), {});
  ASSERT_TRUE(measures.drift);
  EXPECT_NEAR(*measures.drift, 0.02, 1e-9);
}

TEST(ReportMeasures, ARunWithoutReadingsHasNone) {
  ReportRun run = test::report_run("a", 1);
  run.readings = {};
  const Measures measures = measures_of(run, measured_sensors(run.run), {});
  EXPECT_FALSE(measures.noise || measures.drift);
  EXPECT_TRUE(measures.crests.empty());
}

}  // namespace
}  // namespace seiche::apps::report
