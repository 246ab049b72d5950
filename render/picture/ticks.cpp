#include "render/picture/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

double power_of_ten_below(double x) { return std::pow(10.0, std::floor(std::log10(x) + 1e-9)); }

// The smallest round step that cuts the range into no more than `most` parts; rather one, if there is, that meets both
// its ends.
double round_step(Range range, int most) {
  const double least = (range.high - range.low) / most;
  const double fewest = std::min(3.0, 0.5 * most);
  const double base = power_of_ten_below(least);
  const auto meets = [](double end, double step) { return std::abs(end / step - std::round(end / step)) < 1e-6; };
  double smallest = 0;
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    const double step = factor * base;
    if (step < least * (1 - 1e-9) || fewest * step > (range.high - range.low) * (1 + 1e-9)) continue;
    if (smallest == 0) smallest = step;
    if (meets(range.low, step) && meets(range.high, step)) return step;
  }
  return smallest;
}

constexpr double slack = 1e-6;  // of a step: a tick on the range's end belongs to it in spite of rounding

}  // namespace

Ticks round_ticks(Range range, int most) {
  Ticks ticks;
  ticks.step = round_step(range, most);
  const double first = std::ceil(range.low / ticks.step - slack), last = std::floor(range.high / ticks.step + slack);
  for (double k = first; k <= last; ++k) ticks.values.push_back(k == 0 ? 0.0 : k * ticks.step);
  return ticks;
}

std::string tick_label(double value, double step) {
  const double size = std::abs(value);
  const char* sign = value < 0 ? "\u2212" : "";  // a minus, longer than a hyphen
  if (std::max(size, step) >= 1e6 || step < 1e-6) {
    const int digits = size > 0 ? static_cast<int>(std::floor(std::log10(size / step) + slack)) + 2 : 1;
    return fmt::format("{}{:.{}g}", sign, size, std::max(1, digits));  // two of a step, which may be 2.5
  }
  int decimals = 0;
  for (double rest = step; std::abs(rest - std::round(rest)) > 1e-6 * rest; rest *= 10) ++decimals;
  return fmt::format("{}{:.{}f}", sign, size, decimals);
}

Range rounded(Range range) {
  if (!(range.high > range.low)) range.high = range.low + 1;
  const double step = round_step(range, most_ticks);
  return {step * std::floor(range.low / step + slack), step * std::ceil(range.high / step - slack)};
}

double round_below(double length) {
  const double base = power_of_ten_below(length);
  for (const double factor : {5.0, 2.0})
    if (factor * base <= length * (1 + 1e-9)) return factor * base;
  return base;
}

}  // namespace seiche::render
