#include "solver/tank/body.hpp"

#include "solver/tank/mesh/mesh_slice.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "solver/tank/shapes/slice.hpp"

namespace seiche::solver {
namespace {

std::vector<Vec<2>> points_of(const std::vector<std::array<double, 2>>& pairs) {
  std::vector<Vec<2>> points;
  for (const auto& [first, second] : pairs) points.emplace_back(first, second);
  return points;
}

Vec<2> chamfer(const std::array<double, 2>& sides) { return {sides[0], sides[1]}; }

Extruded rectangle(const Parameters::Tank& tank, double width) {
  const double x = tank.length, y = tank.height;
  const Section section(polygon({{0, 0}, {x, 0}, {x, y}, {0, y}}), {"floor", "right", "roof", "left"});
  return {section, 0, width};
}

}  // namespace

Body tank_body(const Parameters& p) {
  const Parameters::Tank& tank = p.tank;
  const auto along_z = [](double length) { return length > 0 ? length : 1; };
  switch (tank.shape) {
    case TankShape::box:
      break;
    case TankShape::prism:
      return prism(points_of(tank.points), along_z(tank.width));
    case TankShape::membrane:
      return membrane(tank.breadth, tank.height, chamfer(tank.lower_chamfer), chamfer(tank.upper_chamfer),
                      along_z(tank.length));
    case TankShape::cylinder:
      return cylinder(tank.radius, tank.length, tank.axis, tank.ends);
    case TankShape::sphere:
      return sphere(tank.radius);
    case TankShape::revolve:
      return revolve(points_of(tank.points));
    case TankShape::mesh:
      return MeshTank(tank.mesh, p.particles.spacing);
  }
  return rectangle(tank, along_z(tank.width));
}

Section tank_section(const Parameters& p) {
  const Body body = tank_body(p);
  if (p.tank.section) return std::visit([&](const auto& tank) { return slice(tank, *p.tank.section); }, body);
  return std::get<Extruded>(body).section();
}

}  // namespace seiche::solver
