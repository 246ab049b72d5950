#include "solver/check_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "solver/motion/check_motion.hpp"
#include "solver/sensors/sensor_list.hpp"

namespace seiche {
namespace {

void check_whole(const char* key, double length, double l0) {
  const double cells = length / l0;
  const double below = std::floor(cells) * l0, above = std::ceil(cells) * l0;
  if (std::abs(cells - std::round(cells)) > 1e-6 * cells)
    throw BadParameters(fmt::format(
        "{} = {:.6g} m is {:.3f} spacings of {:.6g} m; it must be a whole number of them, as {:.6g} or {:.6g} m are",
        key, length, cells, l0, below, above));
  if (std::lround(cells) < 4)
    throw BadParameters(fmt::format(
        "{} = {:.6g} m is {} spacings of {:.6g} m; a run needs 4 at least: take a smaller particles.spacing", key,
        length, std::lround(cells), l0));
}

void check_name(const char* key, const std::string& name, std::initializer_list<const char*> names) {
  std::string all;
  for (const char* good : names) {
    if (name == good) return;
    all += all.empty() ? good : std::string(", ") + good;
  }
  throw BadParameters(fmt::format("{} = '{}' is none of {}", key, name, all));
}

}  // namespace

void check_parameters(const Parameters& p) {
  check_name("motion.type", p.motion.type, {"none", "surge", "heave", "roll", "harmonics", "file"});
  const double l0 = p.particles.spacing;
  check_whole("tank.length", p.tank.length, l0);
  check_whole("tank.height", p.tank.height, l0);
  if (p.tank.width > 0) check_whole("tank.width", p.tank.width, l0);
  check_whole("fluid.depth", p.fluid.depth, l0);
  if (p.fluid.column > 0) check_whole("fluid.column", p.fluid.column, l0);
  if (p.fluid.depth > p.tank.height)
    throw BadParameters(
        fmt::format("fluid.depth = {:.6g} m is more than tank.height = {:.6g} m", p.fluid.depth, p.tank.height));
  if (p.fluid.column > p.tank.length)
    throw BadParameters(
        fmt::format("fluid.column = {:.6g} m is more than tank.length = {:.6g} m", p.fluid.column, p.tank.length));
  if (p.fluid.wave_amplitude != 0 && p.fluid.column > 0)
    throw BadParameters("fluid.wave_amplitude needs liquid in the whole tank: leave fluid.column out");
  if (p.fluid.wave_amplitude != 0 && 4 * l0 * p.fluid.wave_mode > p.tank.length)
    throw BadParameters(
        fmt::format("fluid.wave_mode = {} makes half a wave {:.3g} spacings long; a run needs 4 at least",
                    p.fluid.wave_mode, p.tank.length / (p.fluid.wave_mode * l0)));
  if (p.method.order == Order::move_first && p.method.shift > 0)
    throw BadParameters(
        fmt::format("method.shift = {:.6g} needs method.order = project-first: the other order moves "
                    "particles twice and leaves no place for a shift",
                    p.method.shift));
  solver::check_motion(p);
  const double particles = p.tank.length * p.tank.height / (l0 * l0) * (p.tank.width > 0 ? p.tank.width / l0 : 1);
  if (particles > 1e8)
    throw BadParameters(
        fmt::format("particles.spacing = {:.6g} m asks for some {:.2g} particles; the limit is 1e8", l0, particles));
  solver::check_sensors(p);
}

}  // namespace seiche
