#pragma once
#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// Throws BadParameters where two edges of the outline go through each other; that they touch is no crossing.
void check_no_crossing(const Outline& outline);

}  // namespace seiche::solver::modes
