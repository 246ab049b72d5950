#include <fmt/format.h>

#include "solver/errors.hpp"
#include "solver/tank/baffles/baffled_body.hpp"
#include "solver/tank/baffles/baffles_of.hpp"
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

/// Without baffles.
template <int D>
std::shared_ptr<const Shape<D>> tank_alone(const Parameters& p) {
  if (is_lattice_box(p)) return std::make_shared<Box<D>>(p);
  if constexpr (D == 2)
    return std::make_shared<Section>(tank_section(p));
  else
    return std::visit(
        [](auto body) -> std::shared_ptr<const Shape<3>> { return std::make_shared<decltype(body)>(std::move(body)); },
        tank_body(p));
}

/// How far liquid may see past the end of a baffle [m].
double reach_of(const Parameters& p) { return (longest_support(p.method) + 1) * p.particles.spacing; }

void check_baffles_of(const Parameters& p) {
  if (!has_baffles(p.tank)) return;
  if (p.method.wall_model != WallModel::ghosts)
    throw BadParameters(fmt::format(
        "[[tank.baffle]] and [[tank.ring]] need method.wall_model = \"ghosts\": {} would act through a thin wall",
        name(p.method.wall_model)));
  const double l0 = p.particles.spacing;
  if (p.dimension() == 3) {
    auto tank = tank_alone<3>(p);
    check_baffles(*tank, flat_baffles(p, tank->bounds()), l0);
  } else {
    auto tank = tank_alone<2>(p);
    check_baffles(*tank, baffle_lines(p, tank->bounds()), l0);
  }
}

}  // namespace

template <>
std::shared_ptr<const Shape<2>> make_shape(const Parameters& p) {
  auto tank = tank_alone<2>(p);
  const auto baffles = baffle_lines(p, tank->bounds());
  if (baffles.empty()) return tank;
  return std::make_shared<Baffled>(tank, baffles, p.particles.spacing, reach_of(p));
}

template <>
std::shared_ptr<const Shape<3>> make_shape(const Parameters& p) {
  auto tank = tank_alone<3>(p);
  if (!has_baffles(p.tank)) return tank;
  return std::make_shared<BaffledBody>(tank, flat_baffles(p, tank->bounds()), p.particles.spacing, reach_of(p));
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
