#include "solver/sensors/check_sensors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "solver/errors.hpp"
#include "solver/sensors/pressure_sensor.hpp"
#include "solver/sensors/sensor_kinds.hpp"
#include "solver/sensors/sensor_list.hpp"
#include "solver/sensors/wave_gauge.hpp"

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

template <int D>
bool stands_on_liquid(const Parameters& p, const Shape<D>& tank, const Parameters::WaveGauge& gauge) {
  const Bounds<D> bounds = tank.bounds();
  const LiquidLattice<D> lattice(bounds, bounds.high[1], p.particles.spacing);
  return WaveGauge(gauge.x, gauge.z, bounds.low[1] + p.fluid.depth, tank, lattice).reads();
}

template <int D>
void check_places(const Parameters& p) {
  const auto tank = make_shape<D>(p);
  const Bounds<D> bounds = tank->bounds();
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
  for (const auto& gauge : p.sensors.gauge) {
    check_name("sensors.gauge", gauge.name);
    const double level = bounds.low[1] + p.fluid.depth;
    if (!is_inside<D>(Vec<3>(gauge.x, level, gauge.z).head<D>(), bounds) || !is_in_plane<D>(gauge.z))
      throw BadParameters(fmt::format("sensors.gauge '{}' at x = {:.6g} m, z = {:.6g} m is outside the tank: {}",
                                      gauge.name, gauge.x, gauge.z, tank->description()));
    if (!stands_on_liquid<D>(p, *tank, gauge))
      throw BadParameters(fmt::format(
          "sensors.gauge '{}' at x = {:.6g} m, z = {:.6g} m: the tank has no liquid there at its still level "
          "y = {:.6g} m; move it",
          gauge.name, gauge.x, gauge.z, level));
  }
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
