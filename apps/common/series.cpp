#include "apps/common/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/common/csv.hpp"

namespace seiche::apps {
namespace {

std::size_t place(const Csv& table, const std::string& name) {
  const auto found = std::find(table.titles().begin(), table.titles().end(), name);
  if (found == table.titles().end()) table.refuse_header(fmt::format("there is no column '{}'", name));
  return found - table.titles().begin();
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
  const Csv table = read_csv(file.string(), "reference");
  const std::size_t t = place(table, over), y = place(table, column);
  Series series;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    series.t.push_back(table.number(row, t));
    series.y.push_back(table.number(row, y));
  }
  return series;
}

}  // namespace seiche::apps
