#pragma once
#include <string>
#include <vector>

#include "solver/parameters.hpp"
#include "solver/particles/vec.hpp"

// Which sensors a run has, where they may stand, and what their columns are called.
namespace seiche::solver {

/// The sensors of a run: those of the parameters, or where a list is empty its default: pressure at the left bottom
/// corner, gauges at the left and the right wall; in 3-D midway across.
Parameters::Sensors sensors_of(const Parameters& p);

/// Throws BadParameters for a sensor that is outside the tank or off its walls, and for names that can't be columns.
void check_sensors(const Parameters& p);

/// Column names with units of `Frame::readings`, as in "p_left_bottom [Pa]".
std::vector<std::string> column_names(const Parameters& p);

}  // namespace seiche::solver
