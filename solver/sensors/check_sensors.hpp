#pragma once
#include "solver/parameters.hpp"

namespace seiche::solver {

/// Throws BadParameters for a sensor that is outside the tank or off its walls, and for names that can't be columns, or
/// of which two make the same column.
void check_sensors(const Parameters& p);

}  // namespace seiche::solver
