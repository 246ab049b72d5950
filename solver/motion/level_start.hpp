#pragma once
#include "solver/parameters.hpp"
#include "solver/tank/level_axes.hpp"

namespace seiche::solver {

/// Under what the liquid starts at rest in the tank: gravity alone, or with motion.start = level what acts at t = 0,
///   R^T (g - a) and the part of the angular velocity that is along it,
/// which are all that an equilibrium can have: what turns the tank's axis, or makes it turn faster, leaves none.
RelativeEquilibrium equilibrium_at_start(const Parameters& p);

/// @throws BadParameters where the liquid can't start so: a column, a wave, or its surface would reach the roof, pass
/// the rim or join two chambers
void check_level_start(const Parameters& p);

}  // namespace seiche::solver
