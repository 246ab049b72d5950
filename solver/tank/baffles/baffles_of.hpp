#pragma once
#include "solver/parameters.hpp"
#include "solver/tank/baffles/baffled.hpp"
#include "solver/tank/baffles/flat_baffle.hpp"

// What a scene's [[tank.baffle]] and [[tank.ring]] make. Each throws BadParameters for one that the run can't have.
namespace seiche::solver {

bool has_baffles(const Parameters::Tank& tank);

/// Those of a run in 2-D: lines, and what its section cuts of those in 3-D.
/// @param bounds of the section
std::vector<BaffleLine> baffle_lines(const Parameters& p, const Bounds<2>& bounds);

/// Those of a run in 3-D.
/// @param bounds of the tank
std::vector<FlatBaffle> flat_baffles(const Parameters& p, const Bounds<3>& bounds);

}  // namespace seiche::solver
