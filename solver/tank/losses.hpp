#pragma once
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// What became of a fluid particle.
enum class Loss { none, leaked, spilled };

/// It is lost past the centres of the wall particles, l0/2 behind the wall's surface: over the rim of an open tank it
/// has spilled, else leaked. The open side of a tank has no end.
template <int D>
Loss loss_of(const Vec<D>& r, const Shape<D>& shape, double l0) {
  if (shape.nearest(r).distance <= 0.5 * l0) return Loss::none;
  return !shape.is_closed() && r[1] > shape.bounds().high[1] ? Loss::spilled : Loss::leaked;
}

}  // namespace seiche::solver
