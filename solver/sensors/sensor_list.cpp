#include "solver/sensors/sensor_list.hpp"

#include <algorithm>

#include "solver/tank/level_axes.hpp"

namespace seiche::solver {

std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

namespace {

/// Least and greatest x at which the wall meets the still level [m].
std::pair<double, double> waterline(const SurfaceMesh& wall, double level) {
  double left = wall.high()[0], right = wall.low()[0];
  for (const auto& patch : wall.patches)
    for (const auto& face : patch.faces)
      for (std::size_t k = 0; k < face.size(); ++k) {
        const auto& from = wall.points[static_cast<std::size_t>(face[k])];
        const auto& to = wall.points[static_cast<std::size_t>(face[(k + 1) % face.size()])];
        if ((from[1] < level) == (to[1] < level)) continue;
        const double x = from[0] + (level - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
        left = std::min(left, x);
        right = std::max(right, x);
      }
  return {left, right};
}

}  // namespace

Parameters::Sensors sensors_of(const Parameters& p) {
  Parameters::Sensors sensors = p.sensors;
  if (!sensors.pressure.empty() && !sensors.gauge.empty()) return sensors;
  const SurfaceMesh tank = wall_surface(p);
  const auto low = tank.low(), high = tank.high();
  const LevelAxes<3> axes(p.gravity);
  const double middle = low[2] + 0.5 * (high[2] - low[2]);
  const bool box = p.tank.shape == TankShape::box, upright = p.gravity.is_upright();
  if (sensors.pressure.empty() && box) sensors.pressure = {{"left_bottom", low[0], low[1], middle, 0}};
  if (sensors.pressure.empty()) {
    const auto lowest = *std::min_element(tank.points.begin(), tank.points.end(), [&](const auto& a, const auto& b) {
      return axes.height(Vec<3>(a.data())) < axes.height(Vec<3>(b.data()));
    });
    sensors.pressure = {{"bottom", lowest[0], lowest[1], lowest[2], 0}};
  }
  if (!sensors.gauge.empty()) return sensors;
  const SurfaceMesh level = on_level_axes(tank, p.gravity);
  const double still = level.low()[1] + p.fluid.depth;
  auto [left, right] = waterline(level, still);
  if (const double tenth = 0.1 * (right - left); !box || !upright) left += tenth, right -= tenth;
  const auto gauge = [&](const char* name, double along) {
    const Vec<3> place = upright ? Vec<3>(along, 0, middle) : axes.in_tank({along, still, axes({0, 0, middle})[2]});
    return Parameters::WaveGauge{name, place[0], place[2], place[1]};
  };
  sensors.gauge = {gauge("left", left), gauge("right", right)};
  return sensors;
}

}  // namespace seiche::solver
