#pragma once
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Share of a cube that lies on one side of a plane (Scardovelli & Zaleski 2000).
/// @param way a vector across the plane
/// @param at the cube, its middle at the origin and its sides of length 1, counts where way . r < at
double share_below(const Vec<3>& way, double at);

}  // namespace seiche::solver
