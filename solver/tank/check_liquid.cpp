#include "solver/tank/check_liquid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solver/errors.hpp"
#include "solver/tank/check_whole.hpp"
#include "solver/tank/level.hpp"
#include "solver/tank/level_axes.hpp"
#include "solver/tank/pools.hpp"

namespace seiche::solver {
namespace {

// Particles of a closed tank need a free surface: where all of them are walled in, nothing gives the pressure a value.
// A column has one at its side.
void check_level(const Parameters& p, const SurfaceMesh& wall) {
  const double l0 = p.particles.spacing, depth = p.fluid.depth, height = wall.size()[1];
  const bool upright_box = p.tank.shape == TankShape::box && p.gravity.is_upright();
  if (depth > height)
    throw BadParameters(fmt::format("fluid.depth = {:.6g} m is more than {}{:.6g} m", depth,
                                    upright_box ? "tank.height = " : "the height of the tank, ", height));
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
  if (!p.gravity.is_upright()) throw BadParameters("fluid.column needs a tank that stands upright: gravity = 9.81");
  if (!p.fluid.seeds.empty())
    throw BadParameters("fluid.column and [[fluid.seed]] both tell where the liquid is; leave one of them");
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
  if (p.gravity.size() == 0 || !p.gravity.is_upright())
    throw BadParameters("fluid.wave_amplitude needs gravity downwards; leave it out, or give gravity = 9.81");
  if (p.fluid.column > 0 || !p.fluid.seeds.empty())
    throw BadParameters(
        "fluid.wave_amplitude needs liquid in the whole tank: leave fluid.column and [[fluid.seed]] out");
  const double half_wave = length / (p.fluid.wave_mode * p.particles.spacing);
  if (half_wave < 4)
    throw BadParameters(
        fmt::format("fluid.wave_mode = {} makes half a wave {:.3g} spacings long; a run needs 4 at least",
                    p.fluid.wave_mode, half_wave));
}

void check_gravity(const Parameters& p) {
  if (p.dimension() == 2 && p.gravity[2] != 0)
    throw BadParameters(
        fmt::format("gravity has {:.6g} m/s^2 along z, across the plane of a 2-D run; leave it out", p.gravity[2]));
  const double size = p.gravity.size();
  if (size > greatest_gravity)
    throw BadParameters(fmt::format("gravity is {:.6g} m/s^2 in all; {} at most are possible", size, greatest_gravity));
}

// The liquid of an open box that leans must not stand above its rim.
void check_rim(const Parameters& p, const SurfaceMesh& wall) {
  if (p.tank.closed || p.gravity.is_upright()) return;
  const LevelAxes<3> axes(p.gravity);
  double rim = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, p.tank.length})
    for (const double z : {0.0, p.tank.width}) rim = std::min(rim, axes.height({x, p.tank.height, z}));
  if (const double level = wall.low()[1] + p.fluid.depth; level > rim + 1e-9 * p.tank.height)
    throw BadParameters(
        fmt::format("fluid.depth = {:.6g} m: the liquid stands {:.6g} m above the lowest point of the open tank's rim, "
                    "as it leans; "
                    "a depth of {:.6g} m at most, or tank.closed = true",
                    p.fluid.depth, level - rim, rim - wall.low()[1]));
}

std::string written(const Parameters& p, const Parameters::Fluid::Seed& seed) {
  return p.dimension() == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g}) m", seed.x, seed.y, seed.z)
                            : fmt::format("({:.6g}, {:.6g}) m", seed.x, seed.y);
}

template <int D>
void check_seeds(const Parameters& p) {
  const auto tank = make_shape<D>(p);
  const LevelAxes<D> axes(p.gravity);
  const double bottom = axes.bounds_of(*tank).low[1];
  for (const auto& seed : p.fluid.seeds) {
    const Vec<D> r = point_of<D>(seed);
    if (D == 2 && seed.z != 0)
      throw BadParameters(
          fmt::format("[[fluid.seed]] at {}: z = {:.6g} m is outside the plane of a 2-D run; leave it out",
                      written(p, seed), seed.z));
    if (tank->nearest(r).distance >= 0)
      throw BadParameters(
          fmt::format("[[fluid.seed]] at {} is outside the tank, {}; move it into the chamber that it fills",
                      written(p, seed), tank->description()));
    if (const double height = axes.height(r) - bottom; height >= seed.depth)
      throw BadParameters(fmt::format(
          "[[fluid.seed]] at {} is {:.6g} m above the lowest point of the tank, not below its level, depth = {:.6g} m",
          written(p, seed), height, seed.depth));
  }
  const auto pools = pools_of(p, *tank);
  for (std::size_t k = 0; k < pools.size(); ++k) {
    if (pools[k].parts.empty())
      throw BadParameters(
          fmt::format("[[fluid.seed]] at {}: the gap there is too narrow for particles; move it, or take "
                      "a smaller particles.spacing",
                      written(p, p.fluid.seeds[k])));
    for (std::size_t other = 0; other < k; ++other)
      if (meet(pools[k], pools[other], tank->baffles().get()))
        throw BadParameters(
            fmt::format("[[fluid.seed]] at {} and at {} fill the same chamber, or one with depth = {:.6g} m and one "
                        "with {:.6g} m that "
                        "are open to each other below these levels; leave one of them, or lower the levels",
                        written(p, p.fluid.seeds[other]), written(p, p.fluid.seeds[k]), p.fluid.seeds[other].depth,
                        p.fluid.seeds[k].depth));
  }
}

}  // namespace

void check_liquid(const Parameters& p, const SurfaceMesh& wall_in_tank) {
  check_gravity(p);
  const SurfaceMesh wall = on_level_axes(wall_in_tank, p.gravity);
  check_column(p, wall.size()[0]);
  check_level(p, wall);
  check_rim(p, wall);
  if (!p.fluid.seeds.empty()) p.dimension() == 3 ? check_seeds<3>(p) : check_seeds<2>(p);
  check_wave(p, wall.size()[0]);
}

}  // namespace seiche::solver
