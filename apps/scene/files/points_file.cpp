#include "apps/scene/files/points_file.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "apps/common/csv.hpp"

namespace seiche::apps {
namespace {

std::optional<double> metres(const std::string& unit) {
  if (unit == "m") return 1;
  if (unit == "cm") return 1e-2;
  if (unit == "mm") return 1e-3;
  return {};
}

Points points_of(const Csv& table, TankShape shape) {
  const std::array<const char*, 2> names = shape == TankShape::revolve ? std::array{"z", "r"} : std::array{"x", "y"};
  std::array<std::size_t, 2> column{};
  std::array<double, 2> unit{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    bool found = false;
    for (std::size_t k = 0; k < table.titles().size(); ++k) {
      const auto [name, of] = parted(table.titles()[k]);
      if (name != names[axis]) continue;
      const auto size = metres(of);
      if (!size)
        table.refuse_header(fmt::format("'{}' has the unit '{}'; expected [m], [cm] or [mm]", table.titles()[k], of));
      column[axis] = k, unit[axis] = *size, found = true;
    }
    if (!found)
      table.refuse_header(fmt::format("there is no column {0}; expected {0} [m] and {1} [m] for a tank.shape = \"{2}\"",
                                      names[axis], names[1 - axis], name(shape)));
  }
  Points points;
  for (std::size_t row = 0; row < table.rows(); ++row)
    points.push_back({unit[0] * table.number(row, column[0]), unit[1] * table.number(row, column[1])});
  if (points.empty()) table.refuse_end("the file has no points");
  return points;
}

}  // namespace

Points parse_points(const std::string& text, const std::string& file, TankShape shape) {
  return points_of(Csv(text, file), shape);
}

Points read_points_file(const std::string& file, TankShape shape) {
  return points_of(read_csv(file, "file of a tank's points"), shape);
}

}  // namespace seiche::apps
