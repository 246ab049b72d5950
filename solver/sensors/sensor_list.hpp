#pragma once
#include <string>

#include "solver/parameters.hpp"

// Which sensors a run has, and where they may stand.
namespace seiche::solver {

constexpr double place_tolerance = 1e-9;  ///< of a place on a wall [m]

/// The sensors of a run: those of the parameters, or where a list is empty its default: pressure at the left bottom
/// corner, gauges at the left and the right wall; in 3-D midway across.
Parameters::Sensors sensors_of(const Parameters& p);

/// A sensor's name as titles say it: "left bottom" of "left_bottom".
std::string in_words(std::string name);

}  // namespace seiche::solver
