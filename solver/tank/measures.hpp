#pragma once
#include "solver/parameters.hpp"

namespace seiche::solver {

/// The tank of that shape before a scene says more: a box has measures to start from, the others none.
Parameters::Tank initial_tank(TankShape shape);

/// Throws BadParameters where the tank lacks a measure that its shape needs, or has one that means nothing to it.
void check_measures(const Parameters::Tank& tank);

}  // namespace seiche::solver
