#pragma once
#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// A half section, x >= 0, together with its mirror image at x = 0. Edges on x = 0 are left out. Throws BadParameters
/// where a point has x < 0.
Contour mirrored(const Contour& half);

}  // namespace seiche::solver
