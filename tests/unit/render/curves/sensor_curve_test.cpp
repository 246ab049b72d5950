#include "render/curves/sensor_curve.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "render/curves/curve_choice.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

SensorCurve curve_of(const std::string& sensor, const std::vector<Reference>& references = {}) {
  Look look;
  look.curves = parse_curves(sensor);
  look.references = references;
  return sensor_curves(test::run_with_sensors({}), look).at(0);  // 0.2 m of water, 1962 Pa
}

void read(SensorCurve& curve, double time, double value) { record(curve, {{time}, {value, value, value, value}}); }

void expect_range(const SensorCurve& curve, double low, double high) {
  EXPECT_NEAR(axis_range(curve).low, low, 1e-9);
  EXPECT_NEAR(axis_range(curve).high, high, 1e-9);
}

}  // namespace

TEST(SensorCurve, KeepsTheReadingsOfItsOwnColumn) {
  SensorCurve curve = curve_of("eta_left");
  record(curve, test::readings(0, 0.1));
  record(curve, {});
  record(curve, test::readings(0.11, 0.2));
  ASSERT_EQ(curve.traces.at(0).series.time.size(), 21u);
  for (std::size_t i = 0; i < 21; ++i)
    EXPECT_EQ(curve.traces.at(0).series.value[i], test::reading(curve.traces.at(0).series.time[i])[1]) << i;
}

TEST(SensorCurve, NoSensorsNoCurves) { EXPECT_TRUE(sensor_curves(test::run_info({}), Look{}).empty()); }

TEST(SensorCurve, TakesTheReferencesOfItsSensorOnly) {
  EXPECT_EQ(curve_of("eta_left", {test::reference()}).references.size(), 1u);
  EXPECT_TRUE(curve_of("eta_right", {test::reference()}).references.empty());
}

TEST(AxisRange, BeginsWithAQuarterOfWhatTheStillLiquidHas) {
  expect_range(curve_of("eta_left"), -0.05, 0.05);
  expect_range(curve_of("surge"), -0.02, 0.02);
  SensorCurve pressure = curve_of("p_left_bottom");
  read(pressure, 0, 1962);
  expect_range(pressure, 1400, 2600);
}

TEST(AxisRange, OfAVolumeShowsItsDrift) {
  RunInfo run = test::run_with_sensors({});
  run.sensors = {{"volume", "m^2", "volume", ColumnKind::volume, Rest::first_value, 0.0012},
                 {"force_y", "N/m", "force y", ColumnKind::force, Rest::first_value, 117.72},
                 {"potential_energy", "J/m", "potential energy", ColumnKind::energy, Rest::zero, 2.3544}};
  Look look;
  look.curves = parse_curves("volume, force_y, potential_energy");
  auto curves = sensor_curves(run, look);
  EXPECT_EQ(curves[0].title, "volume [m\u00b2]");
  const Readings first{{0}, {0.12, -1177.2, 0.1}};
  for (SensorCurve& curve : curves) record(curve, first);
  expect_range(curves[0], 0.1185, 0.1215);  // 0.12 and a hundredth to either side
  expect_range(curves[1], -1300, -1050);    // the weight and a tenth of it
  expect_range(curves[2], -3, 3);           // 2.4 J/m, a hundredth of the weight times the depth
}

TEST(AxisRange, StandsStillUntilReadingsLeaveItThenDoublesOnThatSide) {
  SensorCurve curve = curve_of("eta_left");
  read(curve, 0, 0);
  read(curve, 1, 0.0499);
  expect_range(curve, -0.05, 0.05);
  read(curve, 2, 0.051);
  expect_range(curve, -0.05, 0.1);
  read(curve, 3, -0.3);
  expect_range(curve, -0.4, 0.1);
}

TEST(AxisRange, BeginsWithWhatTheReferencesSpan) {
  Reference reference = test::reference();
  reference.series = {{-1, 0, 5, 11}, {7, -0.2, 0.1, 9}};  // only 0 to 10 s are shown
  SensorCurve curve = curve_of("eta_left", {reference});
  read(curve, 0, 0);
  expect_range(curve, -0.2, 0.1);
  read(curve, 1, 0.12);  // 0.15 above the middle, doubled and rounded
  expect_range(curve, -0.2, 0.3);
}

TEST(AxisRange, TakesNoNoticeOfWhatIsNotFinite) {
  SensorCurve curve = curve_of("eta_left");
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    read(curve, 0, value);
  expect_range(curve, -0.05, 0.05);
  read(curve, 1, 1e30);
  EXPECT_GE(axis_range(curve).high, 1e30);
}

TEST(SensorCurve, TheLatestReadingIsTheLastFiniteOneUpToATime) {
  SensorCurve curve = curve_of("eta_left");
  const Trace& trace = curve.traces.at(0);
  EXPECT_FALSE(latest(trace, 9));
  for (const double time : {0.1, 0.2, 0.3}) read(curve, time, 10 * time);
  read(curve, 0.4, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(latest(trace, 0.05));
  EXPECT_EQ(latest(trace, 0.2), (Point{0.2, 2}));
  EXPECT_EQ(latest(trace, 0.25), (Point{0.2, 2}));
  EXPECT_EQ(latest(trace, 1), (Point{0.3, 3}));
}

TEST(SensorCurve, AFixedAxisStandsStill) {
  SensorCurve curve = curve_of("eta_left");
  curve.axis = Range{-1, 2};
  read(curve, 0, 1000);
  expect_range(curve, -1, 2);
}
