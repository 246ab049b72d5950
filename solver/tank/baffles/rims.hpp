#pragma once
#include "solver/tank/baffles/flat_baffle.hpp"

namespace seiche::solver {

/// Points along a line or round a circle of a flat baffle's rims, half a spacing apart or less, and whether all of them
/// lie on the tank's wall or beyond it.
struct Rim {
  Vecs<3> points;
  bool closed;  ///< a circle
  bool on_wall;
};

/// The rims of a flat baffle.
struct Rims {
  std::vector<Rim> outer;  ///< of a rectangle at -u, +u, -v, +v; of a disc one
  std::vector<Rim> holes;
};

/// @param touching what is nearer to the wall than that is on it [m]
Rims rims_of(const FlatBaffle& baffle, const Shape<3>& tank, double l0, double touching);

/// A baffle with those of its rims moved that lie on the wall: so far into the solid.
FlatBaffle prolonged(const FlatBaffle& baffle, const Rims& rims, double by);

/// Whether any of it lies within the tank.
bool is_in_tank(const FlatBaffle& baffle, const Shape<3>& tank, double l0);

}  // namespace seiche::solver
