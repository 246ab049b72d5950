#pragma once
#include "solver/parameters.hpp"

namespace seiche::solver {

/// Throws BadParameters where a motion lacks what its type needs, has what its type would ignore, or ends before the
/// run does.
void check_motion(const Parameters& parameters);

}  // namespace seiche::solver
