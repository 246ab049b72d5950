#include "apps/report/chart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "render/curves/curve_choice.hpp"
#include "render/curves/running_mean.hpp"
#include "tests/unit/apps/report/synthetic.hpp"

namespace seiche::apps::report {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

const Chart& chart_named(const std::vector<Chart>& charts, const std::string& sensor) {
  return *std::find_if(charts.begin(), charts.end(), [&](const Chart& chart) { return chart.column.name == sensor; });
}

TEST(ReportCharts, AreThoseUnderThePictures) {
  const auto charts = charts_of({"tank", {test::report_run("a", 1)}, {}, {}});
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[0].title, "Elevation, left [m]");
  EXPECT_EQ(charts[1].title, "Pressure, left bottom [Pa]");
  EXPECT_EQ(charts[2].title, "Surge [m]");
}

TEST(ReportCharts, AreTheUsualOnesWhereThePicturesHaveNone) {
  ReportRun run = test::report_run("a", 1);
  run.run.scene.look.curves.emplace();
  EXPECT_EQ(charts_of({"tank", {run}, {}, {}}).size(), 3u);
  run.run.scene.look.curves = render::parse_curves("eta_right");
  const auto charts = charts_of({"tank", {run}, {}, {}});
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].column.name, "eta_right");
}

TEST(ReportCharts, ShowWhatAllRunsHaveOnce) {
  const test::Signals twice{[](double t) { return 0.02 * std::sin(6 * t); }, [](double) { return 0.0; }};
  const auto charts = charts_of({"tank", {test::report_run("a", 2), test::report_run("b", 1, twice)}, {}, {}});
  EXPECT_EQ(chart_named(charts, "eta_left").traces.size(), 2u);
  const Chart surge = chart_named(charts, "surge");
  ASSERT_EQ(surge.traces.size(), 1u) << "though the second run ended sooner";
  EXPECT_EQ(line_style(surge.traces[0]).name, "all");
}

TEST(ReportCharts, PressuresOfSeveralRunsAreTheMeansOfTheirPictures) {
  // A wave of 1 Hz that noise of 250 Hz hides.
  const test::Signals noisy{[](double) { return 0.0; },
                            [](double t) {
                              const double slow = 100 * std::sin(2 * std::numbers::pi * t);
                              return slow + 5000 * std::sin(2 * std::numbers::pi * 250 * t);
                            }};
  const ReportRun a = test::report_run("a", 2, noisy), b = test::report_run("b", 1.8, noisy);
  const Chart raw = chart_named(charts_of({"tank", {a}, {}, {}}), "p_left_bottom");
  EXPECT_EQ(raw.title, "Pressure, left bottom [Pa]");
  EXPECT_GT(extent_of(raw).range.high, 6000) << "a run alone shows its readings";
  EXPECT_EQ(chart_html(raw, true).find("Running means"), std::string::npos);

  ReportRun quieter = b;
  for (double& value : quieter.readings.values) value *= 0.5;
  const Chart mean = chart_named(charts_of({"tank", {a, quieter}, {}, {}}), "p_left_bottom");
  EXPECT_EQ(mean.title, "Pressure, left bottom [Pa], mean of 0.02 s");
  ASSERT_EQ(mean.traces.size(), 2u);
  const render::Series expected = render::running_mean(column_of(a.readings, a.run.info, "p_left_bottom"), 0.02);
  EXPECT_EQ(mean.traces[0].series.value, expected.value);
  EXPECT_LT(extent_of(mean).range.high, 3000);
  EXPECT_NE(chart_html(mean, false).find("Running means; probes.csv has the readings themselves."), std::string::npos);
}

TEST(ReportCharts, ASpikeDoesNotFlattenTheRest) {
  const auto spike = [](double t) { return t == 0.5 ? 1.0 : 0.01 * std::sin(6 * t); };
  const auto charts = charts_of({"tank", {test::report_run("a", 2, {spike, [](double) { return 0.0; }})}, {}, {}});
  const Extent extent = extent_of(chart_named(charts, "eta_left"));
  EXPECT_LE(extent.range.high, 0.02);
  EXPECT_EQ(extent.beyond, 1);
  EXPECT_NE(chart_html(chart_named(charts, "eta_left"), true).find("the furthest is 1.000 m."), std::string::npos);
}

TEST(ReportCharts, ATankThatBurstsDoesNotEither) {
  ReportRun burst = test::failed_run("b", 1, "x");
  for (double& value : burst.readings.values) value *= 100;
  const auto charts = charts_of({"tank", {test::report_run("a", 2), burst}, {}, {}});
  EXPECT_LE(extent_of(chart_named(charts, "eta_left")).range.high, 0.02);
  const auto alone = charts_of({"tank", {burst}, {}, {}});
  EXPECT_GE(extent_of(chart_named(alone, "eta_left")).range.high, 1) << "unless there is nothing else to see";
}

TEST(ReportCharts, PeaksOutliveThinning) {
  const auto peak = [](double t) { return std::abs(t - 1.234) < 1e-9 ? 0.012 : 0.01 * std::sin(6 * t); };
  const auto charts = charts_of({"tank", {test::report_run("a", 4, {peak, [](double) { return 0.0; }})}, {}, {}});
  const Chart chart = chart_named(charts, "eta_left");
  const render::Range range = extent_of(chart).range;
  const std::string html = chart_html(chart, true);
  EXPECT_NE(html.find(fmt::format("L308.5 {:.1f}", 1000 * (range.high - 0.012) / (range.high - range.low))),
            std::string::npos);
  EXPECT_LT(count(html, "L"), 2000u) << "of 4001 readings";
}

TEST(ReportCharts, HaveALineForEachRunAndReferenceAndACrossWhereOneStopped) {
  ReportRun first = test::report_run("a", 2);
  test::add_reference(
      first, "theory & <all>", [](double t) { return 0.01 * std::cos(6 * t); }, 3);
  ReportRun second = test::failed_run("b", 0.5, "x");
  for (double& value : second.readings.values) value *= 0.9;
  const auto charts = charts_of({"tank", {first, second}, {}, {}});
  const std::string html = chart_html(chart_named(charts, "eta_left"), false);
  EXPECT_EQ(count(html, "<path class=\"run v0\""), 1u);
  EXPECT_EQ(count(html, "<path class=\"run v1\""), 1u);
  EXPECT_EQ(count(html, "<path class=\"reference r0\""), 1u);
  EXPECT_EQ(count(html, "<text class=\"stop v1\" x=\"25.00%\""), 1u);
  EXPECT_EQ(count(html, "class=\"stop"), 1u);
  EXPECT_NE(html.find("theory &amp; &lt;all&gt;"), std::string::npos);
}

}  // namespace
}  // namespace seiche::apps::report
