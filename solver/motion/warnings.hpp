#pragma once
#include <string>
#include <vector>

#include "solver/parameters.hpp"

namespace seiche {

/// The greatest acceleration that a corner of the tank's bounding box has during the run, and when.
struct PeakAcceleration {
  double value = 0;  ///< [m/s^2]
  double time = 0;   ///< [s]
};

/// Found by ten looks at each interval of a record, or by a thousand.
PeakAcceleration greatest_acceleration(const Parameters& parameters);

/// What is legal and surely not meant, each as a sentence with its figures: a tank of hundreds of metres, accelerations
/// beyond 2 g, a record whose accelerations are made by its rounding, a tank that starts tilted under a flat surface, a
/// record that is held where it moves. The parameters have passed check_parameters.
std::vector<std::string> warnings(const Parameters& parameters);

}  // namespace seiche
