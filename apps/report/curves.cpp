#include "apps/report/curves.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "render/curves.hpp"
#include "render/panels.hpp"
#include "render/picture.hpp"

namespace seiche::apps::report {
namespace {

using Span = std::optional<render::Range>;

void widen(Span& span, double low, double high) {
  span = span ? render::Range{std::min(span->low, low), std::max(span->high, high)} : render::Range{low, high};
}

// The values until `end`, in order of size.
std::vector<double> sorted(const render::Series& series, double end) {
  std::vector<double> values;
  for (std::size_t i = 0; i < series.time.size() && series.time[i] <= end; ++i)
    if (std::isfinite(series.value[i])) values.push_back(series.value[i]);
  std::sort(values.begin(), values.end());
  return values;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// Leaves one trace where all runs have the same, but that some stopped sooner.
void merge(std::vector<Trace>& traces) {
  if (traces.size() < 2) return;
  const auto longest = std::max_element(traces.begin(), traces.end(), [](const Trace& a, const Trace& b) {
    return a.series.value.size() < b.series.value.size();
  });
  const auto is_part = [&](const Trace& trace) {
    return std::equal(trace.series.value.begin(), trace.series.value.end(), longest->series.value.begin(),
                      [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
  };
  if (!std::all_of(traces.begin(), traces.end(), is_part)) return;
  traces = {Trace{"all runs", 0, true, false, false, longest->series}};
}

// Draws the runs as the movie above the curves does.
void settle_as_in_pictures(Chart& chart) {
  render::SensorCurve curve{.column = chart.column};
  curve.title = chart.title;
  curve.end = chart.end;
  for (const Trace& trace : chart.traces) curve.traces.push_back({.series = trace.series, .broken_off = trace.failed});
  std::vector<render::SensorCurve> curves{std::move(curve)};
  render::settle(curves);
  chart.means = curves.front().title != chart.title;
  chart.title = curves.front().title;
  for (std::size_t i = 0; i < chart.traces.size(); ++i)
    chart.traces[i].series = std::move(curves.front().traces[i].series);
}

}  // namespace

std::string title_of(const seiche::Column& column) { return capitalised(render::curve_title(column)); }

std::string heading_of(const seiche::Column& column) { return capitalised(column.title); }

std::vector<seiche::Column> charted(const StoredRun& run) {
  render::Look look = run.scene.look;
  if (!look.draws_curves()) look.curves.reset();
  std::vector<seiche::Column> columns;
  for (const std::size_t column : render::chosen_columns(look, run.info.sensors))
    columns.push_back(run.info.sensors[column]);
  return columns;
}

double reached(const ReportRun& run) {
  if (run.run.record.ending) return run.run.record.ending->time;
  return run.readings.time.empty() ? 0 : run.readings.time.back();
}

double reached(const Report& report) {
  double end = 0;
  for (const ReportRun& run : report.runs) end = std::max(end, reached(run));
  return end;
}

std::vector<render::Reference> references_of(const Report& report, const std::string& sensor) {
  std::vector<render::Reference> found;
  for (const render::Reference& reference : report.runs.front().run.scene.look.references)
    if (reference.of == sensor) found.push_back(reference);
  return found;
}

std::vector<Chart> charts_of(const Report& report) {
  const StoredRun& first = report.runs.front().run;
  std::vector<Chart> charts;
  for (const seiche::Column& column : charted(first)) {
    Chart chart{column, title_of(column), reached(report), {}};
    for (std::size_t i = 0; i < report.runs.size(); ++i) {
      const ReportRun& one = report.runs[i];
      const auto& ending = one.run.record.ending;
      Trace trace{one.label,
                  i,
                  false,
                  false,
                  ending && ending->status == Ending::Status::failed,
                  column_of(one.readings, one.run.info, column.name)};
      if (!trace.series.time.empty()) chart.traces.push_back(std::move(trace));
    }
    if (chart.traces.empty() || chart.end <= 0) continue;
    merge(chart.traces);
    if (report.runs.size() > 1) settle_as_in_pictures(chart);
    const std::vector<render::Reference> references = references_of(report, column.name);
    for (std::size_t i = 0; i < references.size(); ++i)
      chart.traces.push_back({references[i].label, i, false, true, false, references[i].series});
    charts.push_back(std::move(chart));
  }
  return charts;
}

Extent extent_of(const Chart& chart) {
  const bool all_failed =
      std::all_of(chart.traces.begin(), chart.traces.end(), [](const Trace& trace) { return trace.failed; });
  Span all, usual;
  for (const Trace& trace : chart.traces) {
    const std::vector<double> values = sorted(trace.series, chart.end);
    if (values.empty()) continue;
    widen(all, values.front(), values.back());
    if (trace.failed && !all_failed) continue;
    const std::size_t few = trace.reference ? 0 : values.size() / 500;
    widen(usual, values[few], values[values.size() - 1 - few]);
  }
  if (!usual) return {{0, 1}, 0};
  // A quarter to each side, so that what is cut off is cut off for good reason.
  const double room = 0.25 * (usual->high - usual->low);
  const render::Range range =
      render::rounded({std::max(all->low, usual->low - room), std::min(all->high, usual->high + room)});
  const double below = range.low - all->low, above = all->high - range.high;
  if (std::max(below, above) <= 0) return {range, 0};
  return {range, below > above ? all->low : all->high};
}

}  // namespace seiche::apps::report
