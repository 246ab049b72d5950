#pragma once
#include "solver/tank/baffles/flat_baffle.hpp"

namespace seiche::solver {

/// Throws BadParameters for a baffle shorter than a spacing, or one that leaves a gap to the tank's wall or to another
/// baffle which is no contact and less than two spacings wide, with the spacing that would do.
/// @param tank without baffles
void check_baffles(const Shape<2>& tank, const std::vector<BaffleLine>& baffles, double l0);

/// The same in 3-D, along rims and for what is narrower than a spacing; holes are two spacings wide at least.
void check_baffles(const Shape<3>& tank, const std::vector<FlatBaffle>& baffles, double l0);

}  // namespace seiche::solver
