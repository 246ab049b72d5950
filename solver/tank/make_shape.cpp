#include <fmt/format.h>

#include "solver/errors.hpp"
#include "solver/tank/baffles/check_baffles.hpp"
#include "solver/tank/body.hpp"
#include "solver/tank/box.hpp"
#include "solver/tank/filling.hpp"
#include "solver/tank/measures.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {
namespace {

/// Only on the lattice of its liquid can the particles of a box's walls stand; any other is one of the bodies.
bool is_lattice_box(const Parameters& p) {
  return p.tank.shape == TankShape::box && !p.tank.section && fits_lattice(p);
}

std::shared_ptr<const Shape<2>> tank_alone(const Parameters& p) {
  if (is_lattice_box(p)) return std::make_shared<Box<2>>(p);
  return std::make_shared<Section>(tank_section(p));
}

void check_baffles_of(const Parameters& p) {
  if (p.tank.baffles.empty()) return;
  if (p.dimension() == 3)
    throw BadParameters(
        "[[tank.baffle]] needs a run in 2-D: leave tank.width (of a membrane tank.length) out, or give tank.section");
  if (p.method.wall_model != WallModel::ghosts)
    throw BadParameters(
        fmt::format("[[tank.baffle]] needs method.wall_model = \"ghosts\": {} would act through a thin wall",
                    name(p.method.wall_model)));
  check_baffles(*tank_alone(p), baffle_lines(p.tank), p.particles.spacing);
}

}  // namespace

template <>
std::shared_ptr<const Shape<2>> make_shape(const Parameters& p) {
  const auto baffles = baffle_lines(p.tank);
  const auto tank = tank_alone(p);
  if (baffles.empty()) return tank;
  const double l0 = p.particles.spacing;
  return std::make_shared<Baffled>(tank, baffles, l0, (longest_support(p.method) + 1) * l0);
}

template <>
std::shared_ptr<const Shape<3>> make_shape(const Parameters& p) {
  if (is_lattice_box(p)) return std::make_shared<Box<3>>(p);
  return std::visit(
      [](auto body) -> std::shared_ptr<const Shape<3>> { return std::make_shared<decltype(body)>(std::move(body)); },
      tank_body(p));
}

SurfaceMesh wall_surface(const Parameters& p) {
  return p.dimension() == 3 ? make_shape<3>(p)->surface() : make_shape<2>(p)->surface();
}

void check_shape(const Parameters& p) {
  check_measures(p.tank);
  check_baffles_of(p);
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
