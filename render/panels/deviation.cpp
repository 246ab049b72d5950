#include "render/panels/deviation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/curves/curve_choice.hpp"
#include "render/picture/polyline.hpp"

namespace seiche::render {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double value_at(const Series& series, double time) {
  const auto above = std::lower_bound(series.time.begin(), series.time.end(), time * (1 - time_slack));
  if (above == series.time.end()) return nothing;
  const auto i = static_cast<std::size_t>(above - series.time.begin());
  if (i == 0 || std::abs(*above - time) <= time_slack * time)
    return *above > time * (1 + time_slack) ? nothing : series.value[i];
  const double share = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return series.value[i - 1] + share * (series.value[i] - series.value[i - 1]);
}

}  // namespace

double deviation(const Series& series, const Series& reference, double until) {
  double squares = 0;
  long count = 0;
  for (std::size_t i = 0; i < reference.time.size() && reference.time[i] <= until * (1 + time_slack); ++i) {
    const double off = value_at(series, reference.time[i]) - reference.value[i];
    if (!std::isfinite(off)) continue;
    squares += off * off;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : nothing;
}

std::string deviation_text(double deviation, const Column& column, const std::string& label) {
  if (!std::isfinite(deviation)) return "";
  const std::string off = label.empty() ? "" : " off " + label;
  if (is_length(column)) return fmt::format("{:.1f} mm RMS{}", 1000 * deviation, off);
  return fmt::format("{} {} RMS{}",
                     deviation < 100 ? fmt::format("{:.3g}", deviation) : fmt::format("{:.0f}", deviation),
                     raised_powers(column.unit), off);
}

}  // namespace seiche::render
