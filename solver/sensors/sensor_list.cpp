#include "solver/sensors/sensor_list.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {

std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Parameters::Sensors sensors_of(const Parameters& p) {
  Parameters::Sensors sensors = p.sensors;
  const double middle = 0.5 * p.tank.width;
  if (sensors.pressure.empty()) sensors.pressure = {{"left_bottom", 0, 0, middle, 0}};
  if (sensors.gauge.empty()) sensors.gauge = {{"left", 0, middle}, {"right", p.tank.length, middle}};
  return sensors;
}

int wall_axis(const Parameters::PressureSensor& sensor, const Parameters& p) {
  const auto at = [](double x, double wall) { return std::abs(x - wall) <= place_tolerance; };
  if (at(sensor.x, 0) || at(sensor.x, p.tank.length)) return 0;
  if (p.dimension() == 3 && (at(sensor.z, 0) || at(sensor.z, p.tank.width))) return 2;
  if (at(sensor.y, 0) || (p.tank.closed && at(sensor.y, p.tank.height))) return 1;
  return -1;
}

}  // namespace seiche::solver
