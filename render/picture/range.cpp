#include "render/picture/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "render/picture/ticks.hpp"

namespace seiche::render {
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

}  // namespace seiche::render
