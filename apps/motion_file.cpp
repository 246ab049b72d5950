#include "apps/motion_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string_view>

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

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first, last - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end; (end = text.find(at)) != std::string_view::npos; text.remove_prefix(end + 1))
    parts.push_back(trimmed(text.substr(0, end)));
  parts.push_back(trimmed(text));
  return parts;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Parameters::TimeSeries read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark, as spreadsheets write
    std::vector<std::string_view> lines = split(text, '\n');
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    if (lines.empty()) refuse(fmt::format("an empty file; expected a header with {}", known));
    read_header(lines[0]);
    for (line_ = 2; line_ <= lines.size(); ++line_) read_row(lines[line_ - 1]);
    if (series_.time.size() < 4) {
      line_ = lines.size();
      refuse(fmt::format("the file ends after {} samples; expected 4 at least", series_.time.size()));
    }
    return std::move(series_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw BadScene(fmt::format("{}:{}: {}", file_, line_, what));
  }

  void read_header(std::string_view line) {
    bool time = false;
    for (const std::string_view title : split(line, ',')) {
      const auto* column =
          std::find_if(std::begin(columns), std::end(columns), [&](const Column& c) { return c.title == title; });
      if (column == std::end(columns)) refuse(fmt::format("'{}' is no column of a motion; expected {}", title, known));
      for (const Column* other : header_)
        if (other->values == column->values) refuse(fmt::format("'{}' is there a second time", title));
      time |= column->values == &Parameters::TimeSeries::time;
      header_.push_back(column);
    }
    if (!time) refuse(fmt::format("there is no column of times; expected {}", known));
    if (header_.size() < 2) refuse(fmt::format("there is no column of a motion; expected {}", known));
  }

  void read_row(std::string_view line) {
    const auto cells = split(line, ',');
    if (cells.size() != header_.size())
      refuse(fmt::format("{} cells; expected {}, one below each column of the header", cells.size(), header_.size()));
    for (std::size_t k = 0; k < cells.size(); ++k)
      (series_.*header_[k]->values).push_back(header_[k]->unit * number(cells[k], header_[k]->title));
    const auto& t = series_.time;
    if (t.size() > 1 && !(t.back() > t[t.size() - 2]))
      refuse(fmt::format("t = {:g} s; expected a time after the {:g} s of the line above", t.back(), t[t.size() - 2]));
  }

  double number(std::string_view cell, std::string_view title) const {
    if (cell.empty()) refuse(fmt::format("{} is missing; expected a number in each cell", title));
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size())
      refuse(fmt::format("{} = '{}'; expected a number, as in -1.5e-3", title, cell));
    if (!std::isfinite(value)) refuse(fmt::format("{} = {}; expected a finite number", title, cell));
    return value;
  }

  std::string file_;
  std::size_t line_ = 1;
  std::vector<const Column*> header_;
  Parameters::TimeSeries series_;
};

}  // namespace

Parameters::TimeSeries parse_motion(const std::string& text, const std::string& file) {
  return Reader(file).read(text);
}

Parameters::TimeSeries read_motion_file(const std::string& file) {
  // Opening a folder succeeds, reading it throws.
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw BadScene(
        fmt::format("{}: this motion file {}", file, std::filesystem::exists(file) ? "can't be read" : "isn't there"));
  return parse_motion({std::istreambuf_iterator<char>(in), {}}, file);
}

}  // namespace seiche::apps
