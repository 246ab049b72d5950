#include "apps/validate/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace seiche::validate {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
  if (!result.empty() && result.back().ends_with('\r')) result.back().pop_back();
  return result;
}

std::size_t place(const std::vector<std::string>& names, const std::string& name, const std::filesystem::path& file) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::runtime_error(fmt::format("{} has no column '{}'", file.string(), name));
  return found - names.begin();
}

double number(const std::vector<std::string>& row, std::size_t column, const std::filesystem::path& file) {
  try {
    return std::stod(row.at(column));
  } catch (const std::logic_error&) {
    throw std::runtime_error(fmt::format("{} has a row without a number in column {}", file.string(), column + 1));
  }
}

}  // namespace

double Series::at(double time) const {
  const std::size_t i = std::upper_bound(t.begin(), t.end(), time) - t.begin();
  if (i == 0) return y.front();
  if (i == t.size()) return y.back();
  return y[i - 1] + (time - t[i - 1]) / (t[i] - t[i - 1]) * (y[i] - y[i - 1]);
}

Series Series::between(double from, double to) const {
  Series part;
  for (std::size_t i = 0; i < size(); ++i) {
    if (t[i] < from || t[i] > to) continue;
    part.t.push_back(t[i]);
    part.y.push_back(y[i]);
  }
  return part;
}

double median_interval(const std::vector<double>& t) {
  if (t.size() < 2) return 0;
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = t[i + 1] - t[i];
  const auto middle = steps.begin() + steps.size() / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

double rms(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Series read_series(const std::filesystem::path& file, const std::string& over, const std::string& column) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error(fmt::format("can't read {}", file.string()));
  const std::vector<std::string> names = cells(line);
  const std::size_t t = place(names, over, file), y = place(names, column, file);
  Series series;
  while (std::getline(in, line)) {
    const std::vector<std::string> row = cells(line);
    series.t.push_back(number(row, t, file));
    series.y.push_back(number(row, y, file));
  }
  return series;
}

}  // namespace seiche::validate
