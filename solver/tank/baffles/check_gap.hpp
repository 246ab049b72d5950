#pragma once
#include <string>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Throws BadParameters where the distance along a line falls to less than two spacings, the narrowest gap through
/// which liquid flows, and not to contact, and rises again: a line that leaves a wall which it meets is no gap.
/// @param gap at each point [m]
/// @param touching what is less is contact [m]
/// @param closed whether the line goes on from its last point to its first
/// @param what, to_what as in "the baffle" and "the tank's wall"
template <int D>
void check_gap(const Vecs<D>& points, const Scalars& gap, double l0, double touching, bool closed,
               const std::string& what, const std::string& to_what);

}  // namespace seiche::solver
