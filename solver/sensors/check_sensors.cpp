#include "solver/sensors/check_sensors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "solver/errors.hpp"
#include "solver/sensors/load_sensors.hpp"
#include "solver/sensors/pressure_sensor.hpp"
#include "solver/sensors/sensor_kinds.hpp"
#include "solver/sensors/sensor_list.hpp"
#include "solver/sensors/wave_gauges.hpp"

namespace seiche::solver {
namespace {

template <int D>
bool is_inside(const Vec<D>& r, const Bounds<D>& tank) {
  return (r.array() >= tank.low.array() - place_tolerance).all() &&
         (r.array() <= tank.high.array() + place_tolerance).all();
}

template <int D>
std::string written(const Vec<D>& r) {
  return D == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g}) m", r[0], r[1], r[D - 1])
                : fmt::format("({:.6g}, {:.6g}) m", r[0], r[1]);
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

/// In 2-D z is 0.
template <int D>
bool is_in_plane(double z) {
  return D == 3 || std::abs(z) <= place_tolerance;
}

/// Where a gauge stands, as its keys have it.
template <int D>
std::string place_of(const Parameters::WaveGauge& gauge) {
  if (gauge.direction != std::array<double, 3>{}) return written<D>(Vec<3>(gauge.x, gauge.y, gauge.z).head<D>());
  return D == 3 || gauge.z != 0 ? fmt::format("x = {:.6g} m, z = {:.6g} m", gauge.x, gauge.z)
                                : fmt::format("x = {:.6g} m", gauge.x);
}

template <int D>
void check_gauges(const Parameters& p, const Shape<D>& tank) {
  if (p.sensors.gauge.empty()) return;
  const auto pools = levels_of(p, tank);
  const auto lattice = lattice_of_columns(tank, p.gravity, p.particles.spacing);
  const double tolerance = place_tolerance + 1e-6 * p.particles.spacing;
  for (const auto& gauge : p.sensors.gauge) {
    check_name("sensors.gauge", gauge.name);
    const auto refuse = [&](const std::string& what) {
      throw BadParameters(fmt::format("sensors.gauge '{}' at {}{}", gauge.name, place_of<D>(gauge), what));
    };
    if (D == 2 && gauge.direction[2] != 0) refuse(": its direction leaves the plane of a 2-D run");
    const GaugeLine<D> line = line_of(gauge, tank, pools);
    const auto columns = WaveGauges<D>::columns_about(gauge, line, tank, lattice);
    if (!is_in_plane<D>(gauge.z) || !is_inside<D>(line.point, tank.bounds()))
      refuse(fmt::format(" is outside the tank: {}", tank.description()));
    if (columns && !columns->reads())
      refuse(fmt::format(": the tank has no liquid there at its still level, {}; move it", written<D>(line.point)));
    if (!columns && tank.nearest(line.point).distance > tolerance)
      refuse(fmt::format(": the point {} of its line is outside the tank, {}; the nearest point of a wall is {}",
                         written<D>(line.point), tank.description(), written<D>(tank.nearest(line.point).foot)));
  }
}

template <int D>
void check_loads(const Parameters& p, const Shape<D>& tank) {
  if (p.sensors.load.empty()) return;
  const SurfaceMesh wall = tank.surface();
  for (const auto& load : p.sensors.load) {
    check_name("sensors.load", load.name);
    if (LoadSensors<D>::patch_of(load, wall) != LoadSensors<D>::none) continue;
    std::vector<std::string> names{"tank"};
    for (const auto& patch : wall.patches) names.push_back(patch.name);
    throw BadParameters(fmt::format("sensors.load '{}': the tank's wall has no patch '{}'; on is one of {}", load.name,
                                    load.on, fmt::join(names, ", ")));
  }
}

template <int D>
void check_places(const Parameters& p) {
  const auto tank = make_shape<D>(p);
  const double l0 = p.particles.spacing;
  for (const auto& sensor : p.sensors.pressure) {
    check_name("sensors.pressure", sensor.name);
    const Vec<D> r = Vec<3>(sensor.x, sensor.y, sensor.z).head<D>();
    const Nearest<D> wall = tank->nearest(r);
    if (wall.distance > PressureSensor<D>::on_wall_within * l0 || !is_in_plane<D>(sensor.z))
      throw BadParameters(
          fmt::format("sensors.pressure '{}' at {} is outside the tank, {}; the nearest point of a wall is {}",
                      sensor.name, written<D>(r), tank->description(), written<D>(wall.foot)));
    if (sensor.side > 0 && wall.distance < -PressureSensor<D>::on_wall_within * l0)
      throw BadParameters(
          fmt::format("sensors.pressure '{}' at {} has a side but is on no wall; the nearest point of one is {}",
                      sensor.name, written<D>(r), written<D>(wall.foot)));
    if (!(sensor.side >= 0))
      throw BadParameters(fmt::format("sensors.pressure '{}': side = {:.6g} m is below 0", sensor.name, sensor.side));
  }
  check_gauges(p, *tank);
  check_loads(p, *tank);
}

}  // namespace

void check_sensors(const Parameters& p) {
  if (p.dimension() == 3)
    check_places<3>(p);
  else
    check_places<2>(p);
  check_columns(p);
}

}  // namespace seiche::solver
