#include "apps/scene/files/motion_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>

#include "solver/motion/record.hpp"

namespace seiche::apps {
namespace {

constexpr const char* known =
    "t [s] and surge, heave, sway [m] or roll, pitch, yaw [deg] (also in ms, cm, mm, rad), or accelerations of these "
    "in m/s^2, cm/s^2, mm/s^2, g, deg/s^2, rad/s^2";

/// A unit that a column may be in, and what one of it is in that of the series.
struct Unit {
  std::string_view name;
  double size;
  bool acceleration = false;
};

constexpr double degrees = 180 / std::numbers::pi;
constexpr Unit times[] = {{"s", 1}, {"ms", 1e-3}, {"", 1}};
constexpr Unit lengths[] = {
    {"m", 1},          {"cm", 1e-2},           {"mm", 1e-3},           {"m/s^2", 1, true},
    {"m/s2", 1, true}, {"cm/s^2", 1e-2, true}, {"mm/s^2", 1e-3, true}, {"g", solver::standard_gravity, true}};
constexpr Unit angles[] = {{"deg", 1}, {"rad", degrees}, {"deg/s^2", 1, true}, {"rad/s^2", degrees, true}};

/// What a column holds; without a degree of freedom the times.
struct MotionColumn {
  std::size_t place;  ///< in the table
  std::optional<DegreeOfFreedom> moved;
  Unit unit;
};

const DegreeOfFreedomRow* row_named(std::string_view name) {
  const auto found = std::ranges::find(degrees_of_freedom, name, &DegreeOfFreedomRow::name);
  return found == degrees_of_freedom.end() ? nullptr : &*found;
}

std::optional<Unit> unit_in(std::span<const Unit> units, std::string_view name) {
  const auto found = std::ranges::find(units, name, &Unit::name);
  return found == units.end() ? std::nullopt : std::optional(*found);
}

bool is_time(std::string_view name) { return name == "t" || name == "time"; }

/// None where the title isn't one of a motion.
std::optional<MotionColumn> column_of(std::size_t place, const CsvTitle& title) {
  const DegreeOfFreedomRow* row = row_named(title.name);
  if (!row && !is_time(title.name)) return {};
  std::span<const Unit> units = times;
  if (row) units = row->rotation ? std::span<const Unit>(angles) : std::span<const Unit>(lengths);
  const auto unit = unit_in(units, title.unit);
  if (!unit) return {};
  return MotionColumn{place, row ? std::optional(row->value) : std::nullopt, *unit};
}

std::vector<MotionColumn> read_header(const Csv& table, const std::vector<std::string>& wanted) {
  std::vector<MotionColumn> header;
  const auto& titles = table.titles();
  for (std::size_t place = 0; place < titles.size(); ++place) {
    const CsvTitle title = parted(titles[place]);
    if (!wanted.empty() && !is_time(title.name) && std::ranges::find(wanted, title.name) == wanted.end()) continue;
    const auto column = column_of(place, title);
    if (!column)
      table.refuse_header(
          fmt::format("'{}' is no column of a motion; expected {}; motion.columns names those that are "
                      "followed, so that others are ignored",
                      titles[place], known));
    for (const MotionColumn& other : header)
      if (other.moved == column->moved) table.refuse_header(fmt::format("'{}' is there a second time", titles[place]));
    header.push_back(*column);
  }
  const auto has = [&](const std::optional<DegreeOfFreedom>& moved) {
    return std::ranges::find(header, moved, &MotionColumn::moved) != header.end();
  };
  for (const std::string& name : wanted) {
    const DegreeOfFreedomRow* row = row_named(name);
    if (!is_time(name) && !(row && has(row->value)))
      table.refuse_header(fmt::format("motion.columns asks for '{}', which is {}; the file has {}", name,
                                      row ? "missing" : "no degree of freedom", fmt::join(titles, ", ")));
  }
  if (!has({})) table.refuse_header(fmt::format("there is no column of times; expected {}", known));
  if (header.size() < 2) table.refuse_header(fmt::format("there is no column of a motion; expected {}", known));
  return header;
}

}  // namespace

std::vector<std::string> listed(const std::string& names) {
  std::vector<std::string> all;
  std::string name;
  for (const char c : names + ",") {
    if (c != ',') {
      if (c != ' ' && c != '\t') name += c;
      continue;
    }
    if (!name.empty()) all.push_back(name);
    name.clear();
  }
  return all;
}

Parameters::TimeSeries titled_motion(const Csv& table, const std::vector<std::string>& wanted) {
  const auto header = read_header(table, wanted);
  Parameters::TimeSeries series;
  for (const MotionColumn& column : header) {
    std::vector<double>& values = column.moved ? series[*column.moved] : series.time;
    for (std::size_t row = 0; row < table.rows(); ++row)
      values.push_back(column.unit.size * table.number(row, column.place));
  }
  const auto& t = series.time;
  for (std::size_t row = 1; row < t.size(); ++row)
    if (!(t[row] > t[row - 1]))
      table.refuse(row,
                   fmt::format("t = {:g} s; expected a time after the {:g} s of the line above", t[row], t[row - 1]));
  if (t.size() < 4) table.refuse_end(fmt::format("the file ends after {} samples; expected 4 at least", t.size()));
  for (const MotionColumn& column : header)
    if (column.unit.acceleration) series[*column.moved] = solver::integrated_twice(t, series[*column.moved]);
  return series;
}

}  // namespace seiche::apps
