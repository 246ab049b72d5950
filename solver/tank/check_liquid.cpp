#include "solver/tank/check_liquid.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"
#include "solver/tank/check_whole.hpp"
#include "solver/tank/level.hpp"

namespace seiche::solver {
namespace {

// Particles of a closed tank need a free surface: where all of them are walled in, nothing gives the pressure a value.
// A column has one at its side.
void check_level(const Parameters& p, const SurfaceMesh& wall) {
  const double l0 = p.particles.spacing, depth = p.fluid.depth, height = wall.size()[1];
  if (depth > height)
    throw BadParameters(fmt::format("fluid.depth = {:.6g} m is more than {}{:.6g} m", depth,
                                    p.tank.shape == TankShape::box ? "tank.height = " : "the height of the tank, ",
                                    height));
  const double greatest = height - l0;
  if (p.tank.closed && p.fluid.column == 0 && depth > greatest + 1e-6 * l0)
    throw BadParameters(fmt::format(
        "fluid.depth = {:.6g} m leaves {:.3g} spacings of gas below the roof; a run needs 1: a depth of {:.6g} m "
        "({:.4g} % of the tank) at most, or a smaller particles.spacing",
        depth, (height - depth) / l0, greatest, 100 * volume_below(wall, wall.low()[1] + greatest) / volume_of(wall)));
  if (depth < 4 * l0 * (1 - 1e-6))
    throw BadParameters(
        fmt::format("fluid.depth = {:.6g} m is {:.3g} spacings of {:.6g} m; a run needs 4 at least: take a smaller "
                    "particles.spacing",
                    depth, depth / l0, l0));
}

void check_column(const Parameters& p, double length) {
  if (p.fluid.column == 0) return;
  if (p.tank.shape != TankShape::box)
    throw BadParameters(fmt::format("fluid.column needs a box, not a tank.shape = \"{}\"", name(p.tank.shape)));
  for (const auto& [key, side] : {std::pair{"tank.length", p.tank.length},
                                  {"fluid.column", p.fluid.column},
                                  {"tank.height", p.tank.height},
                                  {"fluid.depth", p.fluid.depth}})
    check_whole(key, side, p.particles.spacing);
  if (p.fluid.column > length)
    throw BadParameters(
        fmt::format("fluid.column = {:.6g} m is more than tank.length = {:.6g} m", p.fluid.column, length));
}

void check_wave(const Parameters& p, double length) {
  if (p.fluid.wave_amplitude == 0) return;
  if (p.tank.shape != TankShape::box)
    throw BadParameters(fmt::format("fluid.wave_amplitude needs a box, not a tank.shape = \"{}\"", name(p.tank.shape)));
  if (p.gravity == 0) throw BadParameters("fluid.wave_amplitude needs gravity; leave it out, or give gravity = 9.81");
  if (p.fluid.column > 0)
    throw BadParameters("fluid.wave_amplitude needs liquid in the whole tank: leave fluid.column out");
  const double half_wave = length / (p.fluid.wave_mode * p.particles.spacing);
  if (half_wave < 4)
    throw BadParameters(
        fmt::format("fluid.wave_mode = {} makes half a wave {:.3g} spacings long; a run needs 4 at least",
                    p.fluid.wave_mode, half_wave));
}

}  // namespace

void check_liquid(const Parameters& p, const SurfaceMesh& wall) {
  check_column(p, wall.size()[0]);
  check_level(p, wall);
  check_wave(p, wall.size()[0]);
}

}  // namespace seiche::solver
