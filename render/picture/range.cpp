#include "render/picture/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace seiche::render {
namespace {

double power_of_ten_below(double x) { return std::pow(10.0, std::floor(std::log10(x) + 1e-9)); }

constexpr int usual_steps = 8;

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

std::optional<Range> parse_range(const std::string& text) {
  if (text == "scene" || text == "frame" || text == "run") return std::nullopt;
  const auto wrong = [&] {
    return std::invalid_argument(fmt::format("'{}' is no range; give scene, frame, run or \"min,max\"", text));
  };
  const auto comma = text.find(',');
  if (comma == std::string::npos) throw wrong();
  const auto number = [&](const std::string& part) {
    std::size_t used = 0;
    double value = 0;
    try {
      value = std::stod(part, &used);
    } catch (const std::exception&) {
      throw wrong();
    }
    if (part.find_first_not_of(" \t", used) != std::string::npos || !std::isfinite(value)) throw wrong();
    return value;
  };
  const Range range{number(text.substr(0, comma)), number(text.substr(comma + 1))};
  if (!(range.low < range.high)) throw wrong();
  return range;
}

Ticks round_ticks(Range range, int most) {
  Ticks ticks;
  ticks.step = round_step(range, most);
  const double first = std::ceil(range.low / ticks.step - slack), last = std::floor(range.high / ticks.step + slack);
  for (double k = first; k <= last; ++k) ticks.values.push_back(k == 0 ? 0.0 : k * ticks.step);
  return ticks;
}

Ticks round_ticks(Range range) { return round_ticks(range, usual_steps); }

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
  const double step = round_step(range, usual_steps);
  return {step * std::floor(range.low / step + slack), step * std::ceil(range.high / step - slack)};
}

Range scene_range(const RunInfo& run, Quantity quantity) {
  const double weight = std::abs(run.gravity) * run.depth;
  switch (quantity) {
    case Quantity::pressure:
      return rounded({0, 1.5 * run.density * weight});
    case Quantity::speed:
      return rounded({0, 0.5 * std::sqrt(weight)});
    case Quantity::number_density:
      return {0.8, 1.2};
    case Quantity::free_surface:
    case Quantity::kind:
      break;
  }
  return {0, static_cast<double>(classes_of(quantity).size()) - 1};
}

std::optional<Range> fixed_range(const RunInfo& run, const Look& look) {
  const Quantity quantity = quantity_of(look.quantity);
  if (look.range == "scene" || !classes_of(quantity).empty()) return scene_range(run, quantity);
  return parse_range(look.range);
}

Range fluid_range(const Frame& frame, Quantity quantity) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.kind[i] != Kind::fluid) continue;
    const double value = value_of(quantity, frame, i);
    if (!std::isfinite(value)) continue;
    range = {std::min(range.low, value), std::max(range.high, value)};
  }
  return range.low <= range.high ? range : Range{0, 0};
}

double round_below(double length) {
  const double base = power_of_ten_below(length);
  for (const double factor : {5.0, 2.0})
    if (factor * base <= length * (1 + 1e-9)) return factor * base;
  return base;
}

}  // namespace seiche::render
