#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/choice.hpp"

// What a key of a scene may hold, whether it stands in a section or in the tables of a list.
namespace seiche::apps {

/// A value as a scene file or a command line gives it.
using Numbers = std::vector<double>;
using Points = std::vector<std::array<double, 2>>;
using Rows = std::vector<Numbers>;
using Value = std::variant<bool, std::int64_t, double, std::string, Numbers, Points, Rows>;

/// Members of a scene that hold points in space, and circles there by centre and radius.
using Triple = std::array<double, 3>;
using Triples = std::vector<Triple>;
using Quadruples = std::vector<std::array<double, 4>>;

/// Numbers that a key takes; the lower end may be left out.
struct Range {
  double low, high;
  bool above_low = false;  ///< low itself is refused
};

/// Above any tank [m]; catches millimetres given as metres.
constexpr double huge = 1000;

/// Of a motion or a wave; one that is negative has the opposite phase [m], roll [degrees].
constexpr Range amplitudes{-100, 100};

/// Words that a key takes.
using Choices = std::vector<std::string_view>;

/// What scenes call the values of an enum.
template <class E>
Choices names() {
  Choices all;
  for (const Choice<E>& row : ChoiceTable<E>::rows) all.push_back(row.name);
  return all;
}

/// Of is_column_name. In a list each table has another.
struct Name {};

/// Any text.
struct Text {};

/// A number, or a list of so many of them.
struct OneOr {
  Range range;
  std::size_t count;
};

/// A list of pairs of numbers.
struct Pairs {
  Range range;
};

/// So many numbers.
struct Tuple {
  Range range;
  std::size_t count;
};

/// A list of lists of so many numbers.
struct Tuples {
  Range range;
  std::size_t count;
};

using Rule = std::variant<std::monostate, Range, Choices, Name, Text, OneOr, Pairs, Tuple, Tuples>;

/// The member of a scene behind a key.
using Target = std::variant<double*, int*, bool*, std::string*, Numbers*, Points*, Triple*, Triples*, Quadruples*>;

/// All that putting a value into a member needs: how messages name the key and what it takes.
struct Slot {
  Target target;
  const Rule& rule;
  std::string title;     ///< as in "[motion] amplitude"
  std::string expected;  ///< as in "a number from 0 to 10 [m]"
};

/// What a rule lets through, as in "a number from 0 to 10 [m]" or "one of KF1, KF2".
/// @param whole whether only whole numbers do
std::string expected(const Rule& rule, std::string_view unit, bool whole);

/// What every refusal says: the key, the value, why not, and what would do.
std::string refusal(const std::string& title, const std::string& expected, const Value& value, const std::string& why);

/// Puts the value into the slot; a wrong one leaves it as it was and the complaint is returned.
std::optional<std::string> put(const Value& value, const Slot& slot);

/// The value in a member.
Value value_in(const Target& target);

}  // namespace seiche::apps
