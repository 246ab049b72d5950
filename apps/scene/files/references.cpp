#include "apps/scene/files/references.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "apps/common/nearest.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps {
namespace {

std::optional<std::size_t> find(const Csv& table, const std::string& column) {
  for (std::size_t k = 0; k < table.titles().size(); ++k)
    if (table.titles()[k] == column || parted(table.titles()[k]).name == column) return k;
  return {};
}

std::size_t value_column(const Csv& table, const std::string& column, const std::string& unit) {
  const auto found = find(table, column);
  if (!found) {
    const auto guess = nearest(column, table.titles());
    table.refuse_header(fmt::format("there is no column '{}'; expected one of {}{}", column,
                                    fmt::join(table.titles(), ", "),
                                    guess ? fmt::format("; did you mean '{}'?", *guess) : ""));
  }
  const std::string& title = table.titles()[*found];
  const std::string given = parted(title).unit;
  if (!given.empty() && given != unit)
    table.refuse_header(fmt::format("'{}' is in another unit than its sensor; expected [{}]", title, unit));
  return *found;
}

std::size_t time_column(const Csv& table) {
  const auto found = find(table, "t");
  if (!found || (table.titles()[*found] != "t" && table.titles()[*found] != "t [s]"))
    table.refuse_header("there is no column of times; expected t or t [s]");
  return *found;
}

}  // namespace

render::Series reference_series(const Csv& table, const std::string& column, const std::string& unit, double from) {
  const std::size_t times = time_column(table), values = value_column(table, column, unit);
  render::Series series;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = table.number(row, times), above = row > 0 ? table.number(row - 1, times) : time;
    const double value = table.number_or_gap(row, values);
    if (time < above)
      table.refuse(row, fmt::format("t = {:g} s; expected no time before the {:g} s of the line above", time, above));
    if (time < from) continue;
    series.time.push_back(time);
    series.value.push_back(value);
  }
  if (series.time.size() < 2)
    table.refuse_end(fmt::format("the file ends after {} samples{}; expected 2 at least", series.time.size(),
                                 from > 0 ? fmt::format(" from {:g} s on", from) : ""));
  return series;
}

void read_references(Scene& scene, const std::filesystem::path& folder) {
  const std::vector<Column> sensors = sensor_columns(scene.parameters);
  for (render::Reference& reference : scene.look.references) {
    const Csv table = read_csv((folder / reference.file).string(), "reference file");
    if (reference.column.empty()) reference.column = reference.of;
    if (reference.label.empty()) reference.label = std::filesystem::path(reference.file).stem().string();
    reference.series =
        reference_series(table, reference.column, sensors.at(find_column(sensors, reference.of)).unit, reference.from);
  }
}

}  // namespace seiche::apps
