#include "apps/scene/motion_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string_view>
#include <vector>

#include "apps/common/csv.hpp"

namespace seiche::apps {
namespace {

constexpr const char* known = "t [s] and surge [m], heave [m] or roll [deg] (also in ms, cm, mm, rad)";

struct Column {
  std::string_view title;
  std::vector<double> Parameters::TimeSeries::*values;
  double unit;  ///< what one of it is in the unit of the series
};

constexpr double degrees = 180 / std::numbers::pi;
const Column columns[] = {
    {"t [s]", &Parameters::TimeSeries::time, 1},          {"t [ms]", &Parameters::TimeSeries::time, 1e-3},
    {"surge [m]", &Parameters::TimeSeries::surge, 1},     {"surge [cm]", &Parameters::TimeSeries::surge, 1e-2},
    {"surge [mm]", &Parameters::TimeSeries::surge, 1e-3}, {"heave [m]", &Parameters::TimeSeries::heave, 1},
    {"heave [cm]", &Parameters::TimeSeries::heave, 1e-2}, {"heave [mm]", &Parameters::TimeSeries::heave, 1e-3},
    {"roll [deg]", &Parameters::TimeSeries::roll, 1},     {"roll [rad]", &Parameters::TimeSeries::roll, degrees},
};

const Column& column_of(const Csv& table, const std::string& title) {
  for (const Column& column : columns)
    if (column.title == title) return column;
  table.refuse_header(fmt::format("'{}' is no column of a motion; expected {}", title, known));
}

std::vector<const Column*> read_header(const Csv& table) {
  std::vector<const Column*> header;
  bool time = false;
  for (const std::string& title : table.titles()) {
    const Column& column = column_of(table, title);
    for (const Column* other : header)
      if (other->values == column.values) table.refuse_header(fmt::format("'{}' is there a second time", title));
    time |= column.values == &Parameters::TimeSeries::time;
    header.push_back(&column);
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
      (series.*header[k]->values).push_back(header[k]->unit * table.number(row, k));
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
