#include "apps/common/csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

#include "apps/common/errors.hpp"

namespace seiche::apps {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first, last - first + 1);
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (std::size_t end; (end = text.find(at)) != std::string_view::npos; text.remove_prefix(end + 1))
    parts.emplace_back(trimmed(text.substr(0, end)));
  parts.emplace_back(trimmed(text));
  return parts;
}

}  // namespace

Csv::Csv(const std::string& text, std::string file) : file_(std::move(file)) {
  constexpr std::string_view mark = "\xef\xbb\xbf";  // of the byte order, as spreadsheets write
  std::vector<std::string> lines = split(text.starts_with(mark) ? text.substr(mark.size()) : text, '\n');
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  if (lines.empty()) refuse_header("an empty file; expected a header of column titles");
  titles_ = split(lines[0], ',');
  for (std::size_t row = 0; row + 1 < lines.size(); ++row) {
    rows_.push_back(split(lines[row + 1], ','));
    if (rows_[row].size() != titles_.size())
      refuse(row, fmt::format("{} cells; expected {}, one below each column of the header", rows_[row].size(),
                              titles_.size()));
  }
}

double Csv::number(std::size_t row, std::size_t column) const {
  const std::string &cell = rows_[row][column], &title = titles_[column];
  if (cell.empty()) refuse(row, fmt::format("{} is missing; expected a number in each cell", title));
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size())
    refuse(row, fmt::format("{} = '{}'; expected a number, as in -1.5e-3", title, cell));
  if (!std::isfinite(value)) refuse(row, fmt::format("{} = {}; expected a finite number", title, cell));
  return value;
}

double Csv::number_or_gap(std::size_t row, std::size_t column) const {
  return rows_[row][column].empty() ? std::numeric_limits<double>::quiet_NaN() : number(row, column);
}

CsvTitle parted(const std::string& title) {
  const std::size_t bracket = title.find('['), end = title.find(']');
  if (bracket == std::string::npos || end != title.size() - 1) return {title, ""};
  return {std::string(trimmed(title.substr(0, bracket))), title.substr(bracket + 1, end - bracket - 1)};
}

void Csv::refuse_header(const std::string& what) const { throw BadScene(fmt::format("{}:1: {}", file_, what)); }

void Csv::refuse(std::size_t row, const std::string& what) const {
  throw BadScene(fmt::format("{}:{}: {}", file_, row + 2, what));
}

void Csv::refuse_end(const std::string& what) const {
  throw BadScene(fmt::format("{}:{}: {}", file_, rows_.size() + 1, what));
}

std::string read_text_file(const std::string& file, const std::string& what) {
  // Opening a folder succeeds, reading it throws.
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw BadScene(
        fmt::format("{}: this {} {}", file, what, std::filesystem::exists(file) ? "can't be read" : "isn't there"));
  return {std::istreambuf_iterator<char>(in), {}};
}

Csv read_csv(const std::string& file, const std::string& what) { return Csv(read_text_file(file, what), file); }

}  // namespace seiche::apps
