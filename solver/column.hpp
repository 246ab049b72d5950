#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

// What a column of `Frame::readings` is. The sensor that fills it makes it, and nothing else tells what it is.
namespace seiche {

enum class ColumnKind { pressure, elevation, force, moment, energy, volume, centre, swirl, translation, rotation };

/// What a column reads as long as nothing moves.
enum class Rest { zero, first_value };

struct Column {
  std::string name;   ///< of is_column_name, as in "p_left_bottom"
  std::string unit;   ///< as in "Pa"
  std::string title;  ///< in words, as in "pressure, left bottom"
  ColumnKind kind = ColumnKind::pressure;
  Rest rest = Rest::zero;
  double scale = 1;  ///< how far from rest an axis goes before there are readings [unit]

  bool operator==(const Column&) const = default;
};

/// How files head it, as in "p_left_bottom [Pa]".
inline std::string header(const Column& column) { return column.name + " [" + column.unit + "]"; }

/// Whether it is how far or how much the tank has moved.
inline bool is_motion(const Column& column) {
  return column.kind == ColumnKind::translation || column.kind == ColumnKind::rotation;
}

/// Whether it is in metres.
inline bool is_length(const Column& column) {
  return column.kind == ColumnKind::elevation || column.kind == ColumnKind::centre ||
         column.kind == ColumnKind::translation;
}

/// Number of the column of that name, the number of columns if there is none.
inline std::size_t find_column(const std::vector<Column>& columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return static_cast<std::size_t>(found - columns.begin());
}

/// The one rule for names of sensors and columns, in words and as a regular expression. So a comma can part names, and
/// a header's name ends where its unit begins.
constexpr const char* column_name_rule = "a name of a-z, 0-9 and _";
constexpr const char* column_name_pattern = "^[a-z0-9_]+$";

inline bool is_column_name(std::string_view name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

}  // namespace seiche
