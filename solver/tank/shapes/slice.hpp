#pragma once
#include <string>

#include "solver/tank/shapes/extruded.hpp"
#include "solver/tank/shapes/revolved.hpp"

namespace seiche::solver {

/// The plane of a 2-D run, x = at or z = at [m].
struct SlicePlane {
  int axis;  ///< 0 or 2
  double at;
};

/// From text as in "x=0" or "z = 0.1". Throws BadParameters; for y too, as gravity lies across that plane.
SlicePlane read_slice_plane(const std::string& text);

/// The section of a tank in a plane: of z = at in x and y, of x = at in z and y, which then are the run's x and y.
/// Exact but where the plane lies beside and along the axis of a body of revolution: that is a polygon within 1e-6 of
/// the tank's size. Throws BadParameters where the plane misses the tank.
Section slice(const Extruded& tank, const SlicePlane& plane);
Section slice(const Revolved& tank, const SlicePlane& plane);

}  // namespace seiche::solver
