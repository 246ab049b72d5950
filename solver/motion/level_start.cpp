#include "solver/motion/level_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/motion/motion.hpp"
#include "solver/tank/pools.hpp"

namespace seiche::solver {
namespace {

using Eigen::Vector3d;

/// Of an open box its corners are the lowest points of its rim, in an upright paraboloid too: they are the farthest.
double rim_of(const Parameters::Tank& tank, const LevelAxes<3>& axes) {
  double rim = axes.height({0, tank.height, 0});
  for (const double x : {0.0, tank.length})
    for (const double z : {0.0, tank.width}) rim = std::min(rim, axes.height({x, tank.height, z}));
  return rim;
}

template <int D>
void check_pools(const Parameters& p, const RelativeEquilibrium& at_rest) {
  const auto tank = make_shape<D>(p);
  const double l0 = p.particles.spacing, roof = LevelAxes<D>(at_rest).bounds_of(*tank).high[1];
  const auto pools = pools_of(p, *tank, at_rest);
  for (std::size_t k = 0; k < pools.size(); ++k) {
    if (p.tank.closed && roof - pools[k].level < l0 * (1 - 1e-6))
      throw BadParameters(fmt::format(
          "motion.start = level: the liquid would stand {:.3g} spacings below the highest point of the tank as it "
          "starts; a run needs 1: less liquid, or a smaller particles.spacing",
          (roof - pools[k].level) / l0));
    if (const double rim = rim_of(p.tank, LevelAxes<3>(at_rest)); !p.tank.closed && pools[k].level > rim)
      throw BadParameters(fmt::format(
          "motion.start = level: the liquid would stand {:.6g} m above the lowest point of the open tank's rim as it "
          "starts; less liquid, or tank.closed = true",
          pools[k].level - rim));
    for (std::size_t other = 0; other < k; ++other)
      if (meet(pools[k], pools[other], tank->baffles().get()))
        throw BadParameters(
            "motion.start = level: the liquid of two [[fluid.seed]] would meet as the tank starts; less liquid, or "
            "another start");
  }
}

}  // namespace

RelativeEquilibrium equilibrium_at_start(const Parameters& p) {
  if (p.motion.start != Start::level) return {p.gravity};
  const RigidState start = Motion(p.motion).state(0);
  const Vector3d g(p.gravity[0], p.gravity[1], p.gravity[2]);
  const Vector3d pull = start.orientation.conjugate() * (g - start.acceleration);
  const double size = pull.norm();
  // What is left after the rounding of a spline through constant values is nothing.
  constexpr double rounding = 1e-9;
  if (size == 0) return {p.gravity};
  const double spin = std::abs(start.omega.dot(pull) / size);
  const bool steady = (pull - g).norm() <= rounding * size;
  if (steady && spin <= rounding) return {p.gravity};
  return {steady ? p.gravity : Gravity({pull[0], pull[1], pull[2]}),
          spin > rounding ? spin : 0,
          {start.pivot[0], start.pivot[1], start.pivot[2]}};
}

void check_level_start(const Parameters& p) {
  const RelativeEquilibrium at_rest = equilibrium_at_start(p);
  if (at_rest == RelativeEquilibrium{p.gravity}) return;
  for (const auto& [key, given] :
       {std::pair{"fluid.column", p.fluid.column > 0}, {"fluid.wave_amplitude", p.fluid.wave_amplitude != 0}})
    if (given)
      throw BadParameters(
          fmt::format("motion.start = level and {} both tell how the surface starts; leave one out", key));
  p.dimension() == 3 ? check_pools<3>(p, at_rest) : check_pools<2>(p, at_rest);
}

}  // namespace seiche::solver
