#pragma once
#include "solver/tank/baffles/outline.hpp"

namespace seiche::solver {

/// Throws BadParameters for a baffle shorter than a spacing, or one that leaves a gap to the tank's wall or to another
/// baffle which is no contact and less than two spacings wide, with the spacing that would do.
/// @param tank without baffles
void check_baffles(const Shape<2>& tank, const std::vector<BaffleLine>& baffles, double l0);

}  // namespace seiche::solver
