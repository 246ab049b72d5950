#pragma once
#include "solver/errors.hpp"
#include "solver/parameters.hpp"

namespace seiche {

/// Throws BadParameters where the parameters don't fit together (a length that is no whole number of spacings ...).
void check_parameters(const Parameters& parameters);

}  // namespace seiche
