#pragma once
#include "solver/motion/motion.hpp"
#include "solver/tank/filling.hpp"

namespace seiche::solver {

/// No point of the tank, wall particles included, is ever displaced by more on each axis [m].
inline Double3 excursion(const Parameters& p) {
  // The walls' particles stand outside of the wall's surface.
  const SurfaceMesh tank = wall_surface(p);
  const double walls = wall_layers(p.method) * p.particles.spacing;
  Double3 low = tank.low(), high = tank.high();
  for (std::size_t axis = 0; axis < 3; ++axis) low[axis] -= walls, high[axis] += walls;
  return Motion(p.motion).extent(low, high);
}

}  // namespace seiche::solver
