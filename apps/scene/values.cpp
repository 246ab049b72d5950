#include "apps/scene/values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "apps/common/nearest.hpp"
#include "solver/column.hpp"

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
                               [](const Points& points) { return fmt::format("a list of {} pairs", points.size()); },
                               [](const auto& other) { return fmt::format("{}", other); }},
                    value);
}

bool holds(const Range& range, double number) {
  return (range.above_low ? number > range.low : number >= range.low) && number <= range.high;
}

std::string refusal(const Slot& slot, const Value& value, const std::string& why) {
  return apps::refusal(slot.title, slot.expected, value, why);
}

// What is wrong with a word; nothing if it will do.
std::optional<std::string> wrong_word(const Slot& slot, const std::string& word) {
  if (std::holds_alternative<Text>(slot.rule)) return {};
  if (std::holds_alternative<Name>(slot.rule)) {
    if (is_column_name(word)) return {};
    return refusal(slot, word, "is not a name");
  }
  const Choices& choices = std::get<Choices>(slot.rule);
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return {};
  const auto guess = nearest(word, {choices.begin(), choices.end()});
  return refusal(slot, word, "is not one of its choices") + (guess ? fmt::format("; did you mean '{}'?", *guess) : "");
}

std::optional<std::string> put_text(const Slot& slot, std::string& target, const Value& value) {
  const std::string* word = std::get_if<std::string>(&value);
  if (!word) return refusal(slot, value, "is not text");
  auto complaint = wrong_word(slot, *word);
  if (!complaint) target = *word;
  return complaint;
}

template <class Number>
std::optional<std::string> put_number(const Slot& slot, Number& target, const Value& value) {
  double number = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&value); real && std::is_same_v<Number, double>) {
    number = *real;
  } else {
    return refusal(slot, value, std::is_same_v<Number, double> ? "is not a number" : "is not a whole number");
  }
  if (!std::isfinite(number)) return refusal(slot, value, "is not finite");
  if (!holds(std::get<Range>(slot.rule), number)) return refusal(slot, value, "is out of range");
  target = static_cast<Number>(number);
  return {};
}

std::optional<std::string> put_bool(const Slot& slot, bool& target, const Value& value) {
  const bool* truth = std::get_if<bool>(&value);
  if (!truth) return refusal(slot, value, "is not a boolean");
  target = *truth;
  return {};
}

// One number, or as many as the rule has.
std::optional<std::string> put_numbers(const Slot& slot, Numbers& target, const Value& value) {
  const OneOr& rule = std::get<OneOr>(slot.rule);
  const auto* list = std::get_if<Numbers>(&value);
  Numbers numbers = list ? *list : Numbers(1);
  if (!list) {
    const Rule one = rule.range;
    if (auto complaint = put_number({&numbers[0], one, slot.title, slot.expected}, numbers[0], value)) return complaint;
  } else if (numbers.size() != rule.count) {
    return refusal(slot, value, fmt::format("has {} numbers", numbers.size()));
  }
  for (const double number : numbers)
    if (!holds(rule.range, number)) return refusal(slot, value, "is out of range");
  target = numbers;
  return {};
}

std::optional<std::string> put_points(const Slot& slot, Points& target, const Value& value) {
  const Points* points = std::get_if<Points>(&value);
  if (!points) return refusal(slot, value, "is no list of pairs");
  for (std::size_t k = 0; k < points->size(); ++k)
    for (const double number : (*points)[k])
      if (!holds(std::get<Pairs>(slot.rule).range, number))
        return refusal(slot, Numbers{(*points)[k][0], (*points)[k][1]},
                       fmt::format("(pair {}) is out of range", k + 1));
  target = *points;
  return {};
}

std::optional<std::string> put_tuple(const Slot& slot, Triple& target, const Value& value) {
  const auto* numbers = std::get_if<Numbers>(&value);
  if (!numbers || numbers->size() != target.size()) return refusal(slot, value, "is no list of 3 numbers");
  for (const double number : *numbers)
    if (!holds(std::get<Tuple>(slot.rule).range, number)) return refusal(slot, value, "is out of range");
  std::copy(numbers->begin(), numbers->end(), target.begin());
  return {};
}

template <std::size_t count>
std::optional<std::string> put_tuples(const Slot& slot, std::vector<std::array<double, count>>& target,
                                      const Value& value) {
  const Points* none = std::get_if<Points>(&value);
  const Rows* rows = std::get_if<Rows>(&value);
  if (!rows && !(none && none->empty()))
    return refusal(slot, value, fmt::format("is no list of lists of {} numbers", count));
  std::vector<std::array<double, count>> all;
  for (const Numbers& row : rows ? *rows : Rows()) {
    if (row.size() != count) return refusal(slot, row, fmt::format("has {} numbers", row.size()));
    for (const double number : row)
      if (!holds(std::get<Tuples>(slot.rule).range, number)) return refusal(slot, row, "is out of range");
    std::copy(row.begin(), row.end(), all.emplace_back().begin());
  }
  target = all;
  return {};
}

template <std::size_t count>
Value rows_of(const std::vector<std::array<double, count>>& tuples) {
  Rows rows;
  for (const auto& tuple : tuples) rows.emplace_back(tuple.begin(), tuple.end());
  return rows;
}

}  // namespace

std::string expected(const Rule& rule, std::string_view unit, bool whole) {
  return std::visit(
      Overloaded{[](const Choices& choices) { return fmt::format("one of {}", fmt::join(choices, ", ")); },
                 [](Name) { return std::string(column_name_rule); }, [](Text) { return std::string("text"); },
                 [](std::monostate) { return std::string("true or false"); },
                 [&](const OneOr& some) {
                   return fmt::format("a number from {} to {}{}, or a list of {} such numbers", some.range.low,
                                      some.range.high, unit.empty() ? "" : fmt::format(" [{}]", unit), some.count);
                 },
                 [&](const Pairs& pairs) {
                   return fmt::format("a list of pairs as in [[0, 0], [1, 0], [1, 1]], of numbers from {} to {}{}",
                                      pairs.range.low, pairs.range.high,
                                      unit.empty() ? "" : fmt::format(" [{}]", unit));
                 },
                 [&](const Tuple& tuple) {
                   return fmt::format("a list of {} numbers from {} to {}{}", tuple.count, tuple.range.low,
                                      tuple.range.high, unit.empty() ? "" : fmt::format(" [{}]", unit));
                 },
                 [&](const Tuples& tuples) {
                   return fmt::format("a list of lists of {} numbers from {} to {}{}", tuples.count, tuples.range.low,
                                      tuples.range.high, unit.empty() ? "" : fmt::format(" [{}]", unit));
                 },
                 [&](const Range& range) {
                   const std::string ends = range.above_low ? fmt::format("above {}, up to {}", range.low, range.high)
                                                            : fmt::format("from {} to {}", range.low, range.high);
                   const std::string end = unit.empty() ? "" : fmt::format(" [{}]", unit);
                   return fmt::format("a {}number {}{}", whole ? "whole " : "", ends, end);
                 }},
      rule);
}

std::string refusal(const std::string& title, const std::string& expected, const Value& value, const std::string& why) {
  return fmt::format("{} = {} {}; expected {}", title, shown(value), why, expected);
}

std::optional<std::string> put(const Value& value, const Slot& slot) {
  return std::visit(Overloaded{[&](bool* truth) { return put_bool(slot, *truth, value); },
                               [&](std::string* text) { return put_text(slot, *text, value); },
                               [&](Numbers* numbers) { return put_numbers(slot, *numbers, value); },
                               [&](Points* points) { return put_points(slot, *points, value); },
                               [&](Triple* tuple) { return put_tuple(slot, *tuple, value); },
                               [&](Triples* tuples) { return put_tuples(slot, *tuples, value); },
                               [&](Quadruples* tuples) { return put_tuples(slot, *tuples, value); },
                               [&](auto* number) { return put_number(slot, *number, value); }},
                    slot.target);
}

Value value_in(const Target& target) {
  return std::visit(
      Overloaded{[](int* whole) { return Value(std::int64_t{*whole}); },
                 [](Numbers* numbers) { return numbers->size() == 1 ? Value(numbers->front()) : Value(*numbers); },
                 [](Triple* tuple) { return Value(Numbers(tuple->begin(), tuple->end())); },
                 [](Triples* tuples) { return rows_of(*tuples); }, [](Quadruples* tuples) { return rows_of(*tuples); },
                 [](auto* other) { return Value(*other); }},
      target);
}

}  // namespace seiche::apps
