#pragma once
#include "solver/motion/motion.hpp"
#include "solver/tank/tank.hpp"

namespace seiche::solver {

/// No point of the tank, wall particles included, is ever displaced by more on each axis [m].
inline Double3 excursion(const Parameters& p) {
  // The walls' particles stand outside of the box.
  const double walls = wall_layers(p.method) * p.particles.spacing;
  return Motion(p.motion).extent({-walls, -walls, 0}, {p.tank.length + walls, p.tank.height + walls, 0});
}

}  // namespace seiche::solver
