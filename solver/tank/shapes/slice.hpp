#pragma once
#include "solver/section_plane.hpp"
#include "solver/tank/shapes/extruded.hpp"
#include "solver/tank/shapes/revolved.hpp"

namespace seiche::solver {

/// The section of a tank in a plane: of z = at in x and y, of x = at in z and y, which then are the run's x and y.
/// Exact but where the plane lies beside and along the axis of a body of revolution: that is a polygon within 1e-6 of
/// the tank's size. Throws BadParameters where the plane misses the tank.
Section slice(const Extruded& tank, const SectionPlane& plane);
Section slice(const Revolved& tank, const SectionPlane& plane);

}  // namespace seiche::solver
