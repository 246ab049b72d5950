#include "solver/check_parameters.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/motion/check_motion.hpp"
#include "solver/motion/level_start.hpp"
#include "solver/sensors/check_sensors.hpp"
#include "solver/tank/check_liquid.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {
void check_parameters(const Parameters& p) {
  const double l0 = p.particles.spacing;
  solver::check_shape(p);
  const SurfaceMesh wall = solver::wall_surface(p);
  solver::check_liquid(p, wall);
  if (p.method.order == Order::move_first && p.method.shift > 0)
    throw BadParameters(
        fmt::format("method.shift = {:.6g} needs method.order = project-first: the other order moves "
                    "particles twice and leaves no place for a shift",
                    p.method.shift));
  solver::check_motion(p);
  solver::check_level_start(p);
  const auto [length, height, width] = wall.size();
  const double particles = length * height / (l0 * l0) * (width > 0 ? width / l0 : 1);
  if (particles > 1e8)
    throw BadParameters(
        fmt::format("particles.spacing = {:.6g} m asks for some {:.2g} particles; the limit is 1e8", l0, particles));
  solver::check_sensors(p);
}

}  // namespace seiche
