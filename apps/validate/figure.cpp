#include "apps/validate/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche::apps::validate {
namespace {

std::string number(double value, const std::string& unit) {
  const bool whole = value == std::round(value) && std::abs(value) < 1e4;
  return fmt::format("{}{}{}", whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value),
                     unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string value_text(const Figure& figure) { return number(figure.value, figure.unit); }

std::string target_text(const Figure& figure) {
  if (!figure.target) return "-";
  const auto [low, high] = *figure.target;
  if (low == high) return number(low, figure.unit);
  if (low == -high) return "+-" + number(high, figure.unit);
  if (std::isinf(low)) return "<= " + number(high, figure.unit);
  if (std::isinf(high)) return ">= " + number(low, figure.unit);
  return fmt::format("{} to {}", number(low, ""), number(high, figure.unit));
}

std::string verdict(const Figure& figure) {
  if (!figure.target) return "-";
  if (figure.met()) return figure.known ? "met, no known miss any more" : "met";
  if (std::isnan(figure.value)) return "missed";
  const auto [low, high] = *figure.target;
  const std::string missed = figure.is_known_miss() ? "known miss"
                             : figure.known         ? "missed more than known,"
                                                    : "missed";
  return missed + " by " + number(std::max(low - figure.value, figure.value - high), figure.unit);
}

}  // namespace seiche::apps::validate
