#include "render/curves/sensor_curve.hpp"

#include <algorithm>
#include <cmath>

#include "render/curves/curve_choice.hpp"
#include "render/picture/ticks.hpp"

namespace seiche::render {
namespace {

void widen(std::optional<Range>& range, double value) {
  if (!std::isfinite(value)) return;
  if (!range) range = Range{value, value};
  range = Range{std::min(range->low, value), std::max(range->high, value)};
}

double middle(const SensorCurve& curve) {
  if (curve.column.rest == Rest::zero) return 0;
  const auto& values = curve.traces.at(0).series.value;
  const auto first = std::find_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  return first == values.end() ? 0 : *first;
}

}  // namespace

std::vector<SensorCurve> sensor_curves(const RunInfo& run, const Look& look) {
  std::vector<SensorCurve> curves;
  if (run.sensors.empty()) return curves;
  for (const std::size_t chosen : chosen_columns(look, run.sensors)) {
    const Column& column = run.sensors[chosen];
    SensorCurve curve{.column = column, .title = curve_title(column), .end = run.end};
    curve.traces.push_back({.colour = palette(look.background).curve, .column = chosen});
    for (const Reference& reference : look.references)
      if (reference.of == column.name) curve.references.push_back(reference);
    curves.push_back(std::move(curve));
  }
  return curves;
}

void record(SensorCurve& curve, const Readings& readings, std::size_t trace) {
  if (readings.time.empty()) return;
  auto& [colour, column, series, broken_off] = curve.traces.at(trace);
  const std::size_t columns = readings.values.size() / readings.time.size();
  for (std::size_t row = 0; row < readings.time.size(); ++row) {
    const double value = readings.values[row * columns + column];
    series.time.push_back(readings.time[row]);
    series.value.push_back(value);
    widen(curve.extent, value);
  }
}

std::optional<Point> latest(const Trace& trace, double time) {
  const auto& times = trace.series.time;
  const auto after = std::upper_bound(times.begin(), times.end(), time * (1 + time_slack));
  for (auto row = static_cast<std::size_t>(after - times.begin()); row-- > 0;)
    if (std::isfinite(trace.series.value[row])) return Point{times[row], trace.series.value[row]};
  return {};
}

std::optional<Range> reference_range(const SensorCurve& curve) {
  std::optional<Range> range;
  for (const Reference& reference : curve.references)
    for (std::size_t i = 0; i < reference.series.time.size(); ++i)
      if (reference.series.time[i] >= 0 && reference.series.time[i] <= curve.end)
        widen(range, reference.series.value[i]);
  return range;
}

Range axis_range(const SensorCurve& curve) {
  if (curve.axis) return *curve.axis;
  double centre = middle(curve);
  Range range{centre - curve.column.scale, centre + curve.column.scale};
  if (const auto span = reference_range(curve); span && span->high > span->low) {
    range = *span;
    centre = (range.low + range.high) / 2;
  }
  // Readings are held against the rounded range: those just beyond a reference seldom leave it.
  while (curve.extent && curve.extent->low < rounded(range).low) range.low -= centre - range.low;
  while (curve.extent && curve.extent->high > rounded(range).high) range.high += range.high - centre;
  return rounded(range);
}

Range widest_range(const SensorCurve& curve) {
  const Range now = axis_range(curve);
  const double most = 8 * std::max({curve.column.scale, std::abs(now.low), std::abs(now.high)});
  return {-most, most};
}

}  // namespace seiche::render
