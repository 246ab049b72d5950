#include "apps/scene/files/motion_file.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "apps/common/csv.hpp"

namespace seiche::apps {
namespace {

constexpr const char* known = "t [s] and surge [m], heave [m] or roll [deg] (also in ms, cm, mm, rad)";

/// A unit that a column may be in, and what one of it is in the unit of the series.
struct Unit {
  std::string_view name;
  double size;
};

constexpr Unit times[] = {{"s", 1}, {"ms", 1e-3}};
constexpr Unit lengths[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}};
constexpr Unit angles[] = {{"deg", 1}, {"rad", 180 / std::numbers::pi}};

/// What a column holds; without a degree of freedom the times.
struct Column {
  std::optional<DegreeOfFreedom> moved;
  double unit;

  std::vector<double>& in(Parameters::TimeSeries& series) const { return moved ? series[*moved] : series.time; }
};

std::optional<double> unit_in(std::span<const Unit> units, std::string_view name, const std::string& title) {
  for (const Unit& unit : units)
    if (title == fmt::format("{} [{}]", name, unit.name)) return unit.size;
  return {};
}

Column column_of(const Csv& table, const std::string& title) {
  if (const auto unit = unit_in(times, "t", title)) return {{}, *unit};
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (!row.in_scenes) continue;
    if (const auto unit = unit_in(row.rotation ? std::span<const Unit>(angles) : lengths, row.name, title))
      return {row.value, *unit};
  }
  table.refuse_header(fmt::format("'{}' is no column of a motion; expected {}", title, known));
}

std::vector<Column> read_header(const Csv& table) {
  std::vector<Column> header;
  bool time = false;
  for (const std::string& title : table.titles()) {
    const Column column = column_of(table, title);
    for (const Column& other : header)
      if (other.moved == column.moved) table.refuse_header(fmt::format("'{}' is there a second time", title));
    time |= !column.moved;
    header.push_back(column);
  }
  if (!time) table.refuse_header(fmt::format("there is no column of times; expected {}", known));
  if (header.size() < 2) table.refuse_header(fmt::format("there is no column of a motion; expected {}", known));
  return header;
}

Parameters::TimeSeries motion_of(const Csv& table) {
  const auto header = read_header(table);
  Parameters::TimeSeries series;
  const auto& t = series.time;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < header.size(); ++k)
      header[k].in(series).push_back(header[k].unit * table.number(row, k));
    if (row > 0 && !(t[row] > t[row - 1]))
      table.refuse(row,
                   fmt::format("t = {:g} s; expected a time after the {:g} s of the line above", t[row], t[row - 1]));
  }
  if (t.size() < 4) table.refuse_end(fmt::format("the file ends after {} samples; expected 4 at least", t.size()));
  return series;
}

}  // namespace

Parameters::TimeSeries parse_motion(const std::string& text, const std::string& file) {
  return motion_of(Csv(text, file));
}

Parameters::TimeSeries read_motion_file(const std::string& file) { return motion_of(read_csv(file, "motion file")); }

}  // namespace seiche::apps
