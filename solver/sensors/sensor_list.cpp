#include "solver/sensors/sensor_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "solver/errors.hpp"
#include "solver/motion/motion.hpp"

namespace seiche::solver {
namespace {

constexpr double tolerance = 1e-9;  ///< of a place on a wall [m]

using Point = std::array<double, 3>;

Point size_of(const Parameters& p) { return {p.tank.length, p.tank.height, p.tank.width}; }

bool is_inside(const Point& r, const Parameters& p) {
  const Point size = size_of(p);
  return std::equal(r.begin(), r.end(), size.begin(),
                    [](double x, double end) { return x >= -tolerance && x <= end + tolerance; });
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

void check_name(const char* list, const std::string& name, std::set<std::string>& names) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain))
    throw BadParameters(
        fmt::format("{}: name '{}' can't name a column; use letters, digits, '_' and '-', one at least", list, name));
  if (!names.insert(name).second)
    throw BadParameters(fmt::format("{}: two are called '{}'; give each a name of its own", list, name));
}

}  // namespace

Parameters::Sensors sensors_of(const Parameters& p) {
  Parameters::Sensors sensors = p.sensors;
  const double middle = 0.5 * p.tank.width;
  if (sensors.pressure.empty()) sensors.pressure = {{"left_bottom", 0, 0, middle, 0}};
  if (sensors.gauge.empty()) sensors.gauge = {{"left", 0, middle}, {"right", p.tank.length, middle}};
  return sensors;
}

int wall_axis(const Parameters::PressureSensor& sensor, const Parameters& p) {
  const auto at = [](double x, double wall) { return std::abs(x - wall) <= tolerance; };
  if (at(sensor.x, 0) || at(sensor.x, p.tank.length)) return 0;
  if (p.dimension() == 3 && (at(sensor.z, 0) || at(sensor.z, p.tank.width))) return 2;
  if (at(sensor.y, 0) || (p.tank.closed && at(sensor.y, p.tank.height))) return 1;
  return -1;
}

void check_sensors(const Parameters& p) {
  std::set<std::string> names;
  for (const auto& sensor : p.sensors.pressure) {
    check_name("sensors.pressure", sensor.name, names);
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
  names.clear();
  for (const auto& gauge : p.sensors.gauge) {
    check_name("sensors.gauge", gauge.name, names);
    if (!is_inside({gauge.x, 0, gauge.z}, p))
      throw BadParameters(fmt::format("sensors.gauge '{}' at x = {:.6g} m, z = {:.6g} m is outside the tank: {}",
                                      gauge.name, gauge.x, gauge.z, extent(p)));
  }
}

std::vector<std::string> column_names(const Parameters& p) {
  const bool flat = p.dimension() == 2;
  const Parameters::Sensors sensors = sensors_of(p);
  std::vector<std::string> names;
  for (const auto& sensor : sensors.pressure) names.push_back("p_" + sensor.name + " [Pa]");
  for (const auto& gauge : sensors.gauge) names.push_back("eta_" + gauge.name + " [m]");
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  if (sensors.force && flat) add({"force_x [N/m]", "force_y [N/m]", "moment [N m/m]"});
  if (sensors.force && !flat) add({"force_x [N]", "force_y [N]", "force_z [N]", "moment [N m]"});
  if (sensors.energy && flat) add({"kinetic_energy [J/m]", "potential_energy [J/m]"});
  if (sensors.energy && !flat) add({"kinetic_energy [J]", "potential_energy [J]"});
  if (sensors.volume && flat) add({"volume [m^2]", "x_mass [m]", "y_mass [m]"});
  if (sensors.volume && !flat) add({"volume [m^3]", "x_mass [m]", "y_mass [m]", "z_mass [m]"});
  for (std::string& moved : motion_columns(p.motion)) names.push_back(std::move(moved));
  return names;
}

}  // namespace seiche::solver
