#include "solver/check_parameters.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/motion/check_motion.hpp"
#include "solver/sensors/check_sensors.hpp"
#include "solver/tank/check_whole.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {
void check_parameters(const Parameters& p) {
  const double l0 = p.particles.spacing;
  solver::check_shape(p);
  const auto [length, height, width] = solver::wall_surface(p).high();
  solver::check_whole("fluid.depth", p.fluid.depth, l0);
  if (p.fluid.column > 0) solver::check_whole("fluid.column", p.fluid.column, l0);
  if (p.fluid.depth > height)
    throw BadParameters(
        fmt::format("fluid.depth = {:.6g} m is more than tank.height = {:.6g} m", p.fluid.depth, height));
  if (p.fluid.column > length)
    throw BadParameters(
        fmt::format("fluid.column = {:.6g} m is more than tank.length = {:.6g} m", p.fluid.column, length));
  if (p.fluid.wave_amplitude != 0 && p.fluid.column > 0)
    throw BadParameters("fluid.wave_amplitude needs liquid in the whole tank: leave fluid.column out");
  if (p.fluid.wave_amplitude != 0 && 4 * l0 * p.fluid.wave_mode > length)
    throw BadParameters(
        fmt::format("fluid.wave_mode = {} makes half a wave {:.3g} spacings long; a run needs 4 at least",
                    p.fluid.wave_mode, length / (p.fluid.wave_mode * l0)));
  if (p.method.order == Order::move_first && p.method.shift > 0)
    throw BadParameters(
        fmt::format("method.shift = {:.6g} needs method.order = project-first: the other order moves "
                    "particles twice and leaves no place for a shift",
                    p.method.shift));
  solver::check_motion(p);
  const double particles = length * height / (l0 * l0) * (width > 0 ? width / l0 : 1);
  if (particles > 1e8)
    throw BadParameters(
        fmt::format("particles.spacing = {:.6g} m asks for some {:.2g} particles; the limit is 1e8", l0, particles));
  solver::check_sensors(p);
}

}  // namespace seiche
