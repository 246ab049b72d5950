#include "solver/sensors/sensor_list.hpp"

#include <algorithm>

#include "solver/tank/shape.hpp"

namespace seiche::solver {

std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Parameters::Sensors sensors_of(const Parameters& p) {
  Parameters::Sensors sensors = p.sensors;
  const SurfaceMesh tank = wall_surface(p);
  const auto [left, bottom, near] = tank.low();
  const auto [right, top, far] = tank.high();
  const double middle = near + 0.5 * (far - near);
  if (sensors.pressure.empty()) sensors.pressure = {{"left_bottom", left, bottom, middle, 0}};
  if (sensors.gauge.empty()) sensors.gauge = {{"left", left, middle}, {"right", right, middle}};
  return sensors;
}

}  // namespace seiche::solver
