#include "render/panels/compared_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/curves/curve_choice.hpp"
#include "render/curves/running_mean.hpp"
#include "render/picture/ticks.hpp"

namespace seiche::render {
namespace {

constexpr double left_out = 0.005;  // of the readings, at either end
constexpr double windows = 100;     // of a running mean, in the time axis

// What all but a few of the values span.
void widen(std::optional<Range>& range, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return;
  const auto skip = static_cast<std::ptrdiff_t>(left_out * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + skip, values.end());
  const double low = values[static_cast<std::size_t>(skip)];
  std::nth_element(values.begin(), values.end() - 1 - skip, values.end());
  const double high = *(values.end() - 1 - skip);
  range = range ? Range{std::min(range->low, low), std::max(range->high, high)} : Range{low, high};
}

}  // namespace

std::vector<SensorCurve> compared_curves(const std::vector<Variant>& variants, const Look& look) {
  const RunInfo& first = variants.front().run;
  const auto colours = palette(look.background).runs;
  std::vector<SensorCurve> curves = sensor_curves(first, look);
  if (!look.curves)
    std::erase_if(curves, [](const auto& curve) { return is_motion(curve.column) && curve.references.empty(); });
  for (SensorCurve& curve : curves) {
    curve.traces.clear();
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const RunInfo& run = variants[i].run;
      curve.end = std::max(curve.end, run.end);
      curve.traces.push_back({.colour = colours[i],
                              .column = find_column(run.sensors, curve.column.name),
                              .broken_off = variants[i].failed});
    }
  }
  return curves;
}

void settle(std::vector<SensorCurve>& curves) {
  for (SensorCurve& curve : curves) {
    if (curve.column.kind == ColumnKind::pressure) {
      const double window = curve.end / windows;
      for (Trace& trace : curve.traces) trace.series = running_mean(trace.series, window);
      curve.title += fmt::format(", mean of {:.2g} s", window);
    }
    const bool all = std::all_of(curve.traces.begin(), curve.traces.end(), [](const Trace& t) { return t.broken_off; });
    std::optional<Range> range;
    for (const Trace& trace : curve.traces)
      if (all || !trace.broken_off) widen(range, trace.series.value);
    if (const auto span = reference_range(curve)) widen(range, {span->low, span->high});
    if (range && range->high > range->low) curve.axis = rounded(*range);
  }
}

}  // namespace seiche::render
