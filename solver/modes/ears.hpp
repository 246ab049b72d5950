#pragma once
#include <array>

#include "solver/modes/joined_holes.hpp"

namespace seiche::solver::modes {

/// Triangles, anticlockwise, between the corners of an outline: ears cut one by one (Meisters 1975, two ears theorem).
/// Throws BadParameters where the walk crosses itself.
std::vector<std::array<int, 3>> ears(const Walk& walk, const Outline& outline);

}  // namespace seiche::solver::modes
