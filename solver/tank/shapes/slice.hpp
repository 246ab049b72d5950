#pragma once
#include "solver/section_plane.hpp"
#include "solver/tank/shapes/extruded.hpp"
#include "solver/tank/shapes/revolved.hpp"

namespace seiche::solver {

/// Throws BadParameters where the plane misses what has these bounds.
void check_met(const Bounds<3>& bounds, const SectionPlane& plane);

/// What the loops go round, with those of the tank's patches alone that they have.
/// @param patches of the tank, by the patch of an edge
Section section_of(std::vector<std::vector<Edge>> loops, const std::vector<std::string>& patches);

/// The section of a tank in a plane: of z = at in x and y, of x = at in z and y, which then are the run's x and y.
/// Exact but where the plane lies beside and along the axis of a body of revolution: that is a polygon within 1e-6 of
/// the tank's size. Throws BadParameters where the plane misses the tank.
Section slice(const Extruded& tank, const SectionPlane& plane);
Section slice(const Revolved& tank, const SectionPlane& plane);

}  // namespace seiche::solver
