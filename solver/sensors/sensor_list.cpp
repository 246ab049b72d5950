#include "solver/sensors/sensor_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "solver/errors.hpp"
#include "solver/motion/motion.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {
namespace {

constexpr double tolerance = 1e-9;  ///< of a place on a wall [m]

template <int D>
bool is_inside(const Vec<D>& r, const Bounds<D>& tank) {
  return (r.array() >= tank.low.array() - tolerance).all() && (r.array() <= tank.high.array() + tolerance).all();
}

template <int D>
std::string written(const Vec<D>& r) {
  return D == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g}) m", r[0], r[1], r[D - 1])
                : fmt::format("({:.6g}, {:.6g}) m", r[0], r[1]);
}

void check_name(const char* list, const std::string& name, std::set<std::string>& names) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain))
    throw BadParameters(
        fmt::format("{}: name '{}' can't name a column; use letters, digits, '_' and '-', one at least", list, name));
  if (!names.insert(name).second)
    throw BadParameters(fmt::format("{}: two are called '{}'; give each a name of its own", list, name));
}

template <int D>
void check_in(const Parameters& p) {
  const auto tank = make_shape<D>(p);
  const Bounds<D> bounds = tank->bounds();
  std::set<std::string> names;
  for (const auto& sensor : p.sensors.pressure) {
    check_name("sensors.pressure", sensor.name, names);
    const Vec<D> r = Vec<3>(sensor.x, sensor.y, sensor.z).head<D>();
    if (!is_inside(r, bounds) || (D == 2 && std::abs(sensor.z) > tolerance))
      throw BadParameters(fmt::format("sensors.pressure '{}' at ({:.6g}, {:.6g}, {:.6g}) m is outside the tank: {}",
                                      sensor.name, sensor.x, sensor.y, sensor.z, tank->description()));
    const Nearest<D> wall = tank->nearest(r);
    if (std::abs(wall.distance) > tolerance)
      throw BadParameters(fmt::format("sensors.pressure '{}' at {} is not on a wall; the nearest point of one is {}",
                                      sensor.name, written<D>(r), written<D>(wall.foot)));
    if (!(sensor.side >= 0))
      throw BadParameters(fmt::format("sensors.pressure '{}': side = {:.6g} m is below 0", sensor.name, sensor.side));
  }
  names.clear();
  for (const auto& gauge : p.sensors.gauge) {
    check_name("sensors.gauge", gauge.name, names);
    if (!is_inside<D>(Vec<3>(gauge.x, bounds.low[1], gauge.z).head<D>(), bounds) ||
        (D == 2 && std::abs(gauge.z) > tolerance))
      throw BadParameters(fmt::format("sensors.gauge '{}' at x = {:.6g} m, z = {:.6g} m is outside the tank: {}",
                                      gauge.name, gauge.x, gauge.z, tank->description()));
  }
}

}  // namespace

Parameters::Sensors sensors_of(const Parameters& p) {
  Parameters::Sensors sensors = p.sensors;
  const SurfaceMesh tank = tank_surface(p);
  const auto [left, bottom, near] = tank.low();
  const auto [right, top, far] = tank.high();
  const double middle = near + 0.5 * (far - near);
  if (sensors.pressure.empty()) sensors.pressure = {{"left_bottom", left, bottom, middle, 0}};
  if (sensors.gauge.empty()) sensors.gauge = {{"left", left, middle}, {"right", right, middle}};
  return sensors;
}

void check_sensors(const Parameters& p) { p.dimension() == 3 ? check_in<3>(p) : check_in<2>(p); }

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
