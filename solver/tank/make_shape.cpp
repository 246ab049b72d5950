#include <fmt/format.h>

#include "solver/errors.hpp"
#include "solver/tank/box.hpp"
#include "solver/tank/measures.hpp"
#include "solver/tank/shape.hpp"
#include "solver/tank/shapes/built_in.hpp"
#include "solver/tank/shapes/slice.hpp"

namespace seiche::solver {
namespace {

std::vector<Vec<2>> points_of(const Parameters::Tank& tank) {
  std::vector<Vec<2>> points;
  for (const auto& [first, second] : tank.points) points.emplace_back(first, second);
  return points;
}

Vec<2> chamfer(const std::array<double, 2>& sides) { return {sides[0], sides[1]}; }

/// A box whose sides are no whole numbers of spacings: its wall particles can't stand on the lattice of its liquid.
Extruded any_box(const Parameters::Tank& tank, double width) {
  const double x = tank.length, y = tank.height;
  const Section section(polygon({{0, 0}, {x, 0}, {x, y}, {0, y}}), {"floor", "right", "roof", "left"});
  return {section, 0, width};
}

/// Calls f with the 3-D tank; one that is 2-D has the depth 1 along z.
template <class F>
auto with_body(const Parameters::Tank& tank, F f) {
  const auto along_z = [](double length) { return length > 0 ? length : 1; };
  switch (tank.shape) {
    case TankShape::box:
      break;
    case TankShape::prism:
      return f(prism(points_of(tank), along_z(tank.width)));
    case TankShape::membrane:
      return f(membrane(tank.breadth, tank.height, chamfer(tank.lower_chamfer), chamfer(tank.upper_chamfer),
                        along_z(tank.length)));
    case TankShape::cylinder:
      return f(cylinder(tank.radius, tank.length, tank.axis, tank.ends));
    case TankShape::sphere:
      return f(sphere(tank.radius));
    case TankShape::revolve:
      return f(revolve(points_of(tank)));
  }
  return f(any_box(tank, along_z(tank.width)));
}

bool is_lattice_box(const Parameters& p) {
  return p.tank.shape == TankShape::box && !p.tank.section && fits_lattice(p);
}

}  // namespace

template <>
std::shared_ptr<const Shape<2>> make_shape(const Parameters& p) {
  if (is_lattice_box(p)) return std::make_shared<Box<2>>(p);
  const SectionPlane plane = p.tank.section.value_or(SectionPlane{});
  return with_body(p.tank, [&](const auto& body) -> std::shared_ptr<const Shape<2>> {
    if constexpr (std::is_same_v<decltype(body), const Extruded&>)
      if (!p.tank.section) return std::make_shared<Section>(body.section());
    return std::make_shared<Section>(slice(body, plane));
  });
}

template <>
std::shared_ptr<const Shape<3>> make_shape(const Parameters& p) {
  if (is_lattice_box(p)) return std::make_shared<Box<3>>(p);
  return with_body(p.tank, [](auto body) -> std::shared_ptr<const Shape<3>> {
    return std::make_shared<decltype(body)>(std::move(body));
  });
}

SurfaceMesh wall_surface(const Parameters& p) {
  return p.dimension() == 3 ? make_shape<3>(p)->surface() : make_shape<2>(p)->surface();
}

void check_shape(const Parameters& p) {
  check_measures(p.tank);
  if (p.tank.shape == TankShape::box && !p.tank.closed) return check_box(p);
  const auto size = wall_surface(p).size();
  for (int axis = 0; axis < p.dimension(); ++axis)
    if (const double side = size[static_cast<std::size_t>(axis)]; !(side >= 4 * p.particles.spacing * (1 - 1e-6)))
      throw BadParameters(fmt::format(
          "the tank is {:.6g} m along {}, {:.3g} spacings of {:.6g} m; a run needs 4 at least: take a smaller "
          "particles.spacing",
          side, "xyz"[axis], side / p.particles.spacing, p.particles.spacing));
}

}  // namespace seiche::solver
