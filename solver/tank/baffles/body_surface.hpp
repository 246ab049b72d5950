#pragma once
#include "solver/tank/baffles/cut_polygons.hpp"
#include "solver/tank/baffles/rims.hpp"

namespace seiche::solver {

/// The sides of a baffle as polygons, their normals into it, within the tank: what is farther beyond the wall than
/// `touching` is cut off [m]. Of a plate both sides; of a thick one its rims, too, but for those on the wall.
Polygons3 polygons_of(const FlatBaffle& baffle, const Rims& rims, const Shape<3>& tank, double l0, double touching);

/// Cuts what lies within a thick baffle out of polygons.
void cut_out_baffle(const FlatBaffle& longer, Polygons3& polygons);

}  // namespace seiche::solver
