#include "solver/sensors/check_sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "solver/errors.hpp"
#include "solver/sensors/sensor_kinds.hpp"
#include "solver/sensors/sensor_list.hpp"

namespace seiche::solver {
namespace {

using Point = std::array<double, 3>;

Point size_of(const Parameters& p) { return {p.tank.length, p.tank.height, p.tank.width}; }

bool is_inside(const Point& r, const Parameters& p) {
  const Point size = size_of(p);
  return std::equal(r.begin(), r.end(), size.begin(),
                    [](double x, double end) { return x >= -place_tolerance && x <= end + place_tolerance; });
}

std::string written(const Point& r, const Parameters& p) {
  return p.dimension() == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g}) m", r[0], r[1], r[2])
                            : fmt::format("({:.6g}, {:.6g}) m", r[0], r[1]);
}

/// The ends of the tank, as in "x from 0 to 0.6 m, y from 0 to 0.4 m".
std::string extent(const Parameters& p) {
  return fmt::format("x from 0 to {:.6g} m, y from 0 to {:.6g} m", p.tank.length, p.tank.height) +
         (p.dimension() == 3 ? fmt::format(", z from 0 to {:.6g} m", p.tank.width) : ", and has no z");
}

/// The point of a wall nearest to a point inside the tank.
Point nearest_on_wall(const Point& r, const Parameters& p) {
  const Point size = size_of(p);
  Point best = r;
  double least = size[0];
  for (int axis : {0, 1, 2}) {
    if (axis == 2 && p.dimension() == 2) continue;
    for (const double wall : {0., size[axis]}) {
      if (axis == 1 && wall > 0 && !p.tank.closed) continue;
      if (std::abs(r[axis] - wall) > least) continue;
      least = std::abs(r[axis] - wall);
      best = r;
      best[axis] = wall;
    }
  }
  return best;
}

void check_name(const char* list, const std::string& name) {
  if (!is_column_name(name))
    throw BadParameters(fmt::format("{}: '{}' can't name a column; expected {}", list, name, column_name_rule));
}

void check_columns(const Parameters& p) {
  std::set<std::string> names;
  for (const Column& column : columns_of(p))
    if (!names.insert(column.name).second)
      throw BadParameters(
          fmt::format("sensors: two make the column '{}'; give each a name of its own", header(column)));
}

}  // namespace

void check_sensors(const Parameters& p) {
  for (const auto& sensor : p.sensors.pressure) {
    check_name("sensors.pressure", sensor.name);
    const Point r{sensor.x, sensor.y, sensor.z};
    if (!is_inside(r, p))
      throw BadParameters(fmt::format("sensors.pressure '{}' at ({:.6g}, {:.6g}, {:.6g}) m is outside the tank: {}",
                                      sensor.name, r[0], r[1], r[2], extent(p)));
    if (wall_axis(sensor, p) < 0)
      throw BadParameters(fmt::format("sensors.pressure '{}' at {} is not on a wall; the nearest point of one is {}",
                                      sensor.name, written(r, p), written(nearest_on_wall(r, p), p)));
    if (!(sensor.side >= 0))
      throw BadParameters(fmt::format("sensors.pressure '{}': side = {:.6g} m is below 0", sensor.name, sensor.side));
  }
  for (const auto& gauge : p.sensors.gauge) {
    check_name("sensors.gauge", gauge.name);
    if (!is_inside({gauge.x, 0, gauge.z}, p))
      throw BadParameters(fmt::format("sensors.gauge '{}' at x = {:.6g} m, z = {:.6g} m is outside the tank: {}",
                                      gauge.name, gauge.x, gauge.z, extent(p)));
  }
  check_columns(p);
}

}  // namespace seiche::solver
