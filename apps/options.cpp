#include "apps/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "apps/nearest.hpp"

namespace seiche::apps {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

std::string shown(const Value& value) {
  return std::visit(Overloaded{[](const std::string& text) { return fmt::format("'{}'", text); },
                               [](const auto& other) { return fmt::format("{}", other); }},
                    value);
}

bool holds(const Range& range, double number) {
  return (range.above_low ? number > range.low : number >= range.low) && number <= range.high;
}

// What every refusal says: the value, and what would do.
std::string refusal(const Option& option, const Value& value, const std::string& why) {
  return fmt::format("{} = {} {}; expected {}", title(option), shown(value), why, expected(option));
}

std::optional<std::string> assign_word(const Option& option, std::string& target, const Value& value) {
  const std::string* word = std::get_if<std::string>(&value);
  if (!word) return refusal(option, value, "is no text");
  const Choices& choices = std::get<Choices>(option.rule);
  if (std::find(choices.begin(), choices.end(), *word) == choices.end()) {
    std::string complaint = refusal(option, value, "is none of its choices");
    if (const auto guess = nearest(*word, {choices.begin(), choices.end()})) {
      complaint += fmt::format("; did you mean '{}'?", *guess);
    }
    return complaint;
  }
  target = *word;
  return {};
}

template <class Number>
std::optional<std::string> assign_number(const Option& option, Number& target, const Value& value) {
  double number = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&value); real && std::is_same_v<Number, double>) {
    number = *real;
  } else {
    return refusal(option, value, std::is_same_v<Number, double> ? "is no number" : "is no whole number");
  }
  if (!std::isfinite(number)) return refusal(option, value, "is not finite");
  if (!holds(std::get<Range>(option.rule), number)) return refusal(option, value, "is out of range");
  target = static_cast<Number>(number);
  return {};
}

std::optional<std::string> assign_bool(const Option& option, bool& target, const Value& value) {
  const bool* truth = std::get_if<bool>(&value);
  if (!truth) return refusal(option, value, "is neither");
  target = *truth;
  return {};
}

std::optional<std::string> assign_written(const Option& option, const Written& written, Scene& scene,
                                          const Value& value) {
  const std::string* text = std::get_if<std::string>(&value);
  if (!text) return refusal(option, value, "is no text");
  try {
    written.set(scene, *text);
  } catch (const std::invalid_argument&) {
    return refusal(option, value, "cannot be used");
  }
  return {};
}

}  // namespace

std::vector<std::string> sections() {
  std::vector<std::string> result;
  for (const Option& option : options()) {
    if (result.empty() || result.back() != option.section) result.emplace_back(option.section);
  }
  return result;
}

const Option* find_option(std::string_view section, std::string_view key) {
  for (const Option& option : options()) {
    if (option.section == section && option.key == key) return &option;
  }
  return nullptr;
}

std::string title(const Option& option) {
  return option.section.empty() ? std::string(option.key) : fmt::format("[{}] {}", option.section, option.key);
}

std::string dotted(const Option& option) {
  return option.section.empty() ? std::string(option.key) : fmt::format("{}.{}", option.section, option.key);
}

std::string expected(const Option& option) {
  const std::string unit = option.unit.empty() ? "" : fmt::format(" [{}]", option.unit);
  if (const auto* written = std::get_if<Written>(&option.access)) return fmt::format("{}{}", written->form, unit);
  if (const auto* choices = std::get_if<Choices>(&option.rule))
    return fmt::format("one of {}", fmt::join(*choices, ", "));
  if (const auto* range = std::get_if<Range>(&option.rule)) {
    const bool whole = std::holds_alternative<int& (*)(Scene&)>(option.access);
    const std::string ends = range->above_low ? fmt::format("above {}, up to {}", range->low, range->high)
                                              : fmt::format("from {} to {}", range->low, range->high);
    return fmt::format("a {}number {}{}", whole ? "whole " : "", ends, unit);
  }
  return "true or false";
}

std::optional<std::string> assign(const Option& option, Scene& scene, const Value& value) {
  return std::visit(Overloaded{[&](double& (*at)(Scene&)) { return assign_number(option, at(scene), value); },
                               [&](int& (*at)(Scene&)) { return assign_number(option, at(scene), value); },
                               [&](bool& (*at)(Scene&)) { return assign_bool(option, at(scene), value); },
                               [&](std::string& (*at)(Scene&)) { return assign_word(option, at(scene), value); },
                               [&](const Written& written) { return assign_written(option, written, scene, value); }},
                    option.access);
}

Value value_of(const Option& option, const Scene& scene) {
  Scene copy = scene;  // The table reaches members for writing only; one copy a key is cheap.
  return std::visit(Overloaded{[&](double& (*at)(Scene&)) { return Value(at(copy)); },
                               [&](int& (*at)(Scene&)) { return Value(std::int64_t{at(copy)}); },
                               [&](bool& (*at)(Scene&)) { return Value(at(copy)); },
                               [&](std::string& (*at)(Scene&)) { return Value(at(copy)); },
                               [&](const Written& written) { return Value(written.get(copy)); }},
                    option.access);
}

}  // namespace seiche::apps
