#include "render/picture/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "render/picture/ticks.hpp"

namespace seiche::render {
namespace {

constexpr std::array sources{std::pair{RangeSource::scene, "scene"}, std::pair{RangeSource::frame, "frame"},
                             std::pair{RangeSource::run, "run"}};

}  // namespace

RangeChoice parse_range(const std::string& text) {
  for (const auto& [source, name] : sources)
    if (text == name) return {source, {}};
  const auto wrong = [&] {
    return std::invalid_argument(fmt::format("unknown range '{}'; expected scene, frame, run or \"min,max\"", text));
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
  return {RangeSource::given, range};
}

std::string text_of(const RangeChoice& range) {
  for (const auto& [source, name] : sources)
    if (range.source == source) return name;
  return fmt::format("{},{}", range.given.low, range.given.high);
}

Range scene_range(const RunInfo& run, Quantity quantity) {
  const auto [low, high] = row_of(quantity).usual(run);
  return classes_of(quantity).empty() ? rounded({low, high}) : Range{low, high};
}

std::optional<Range> fixed_range(const RunInfo& run, const Look& look) {
  if (look.range.source == RangeSource::scene || !classes_of(look.quantity).empty())
    return scene_range(run, look.quantity);
  if (look.range.source == RangeSource::given) return look.range.given;
  return std::nullopt;
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
