#pragma once
#include "solver/particles/state.hpp"
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

/// Fluid particles that left the tank.
struct Lost {
  long leaked = 0;   ///< through a wall
  long spilled = 0;  ///< over the rim of an open tank
};

/// Removes them from the state, and counts them.
template <int D>
Lost take_out_lost(const Shape<D>& tank, double l0, State<D>& s) {
  const auto loss = [&](int i) { return s.kind[i] == Kind::fluid ? loss_of(s.position[i], tank, l0) : Loss::none; };
  const int size = static_cast<int>(s.size());
  Lost lost;
  for (int i = 0; i < size; ++i) {
    const Loss now = loss(i);
    lost.leaked += now == Loss::leaked;
    lost.spilled += now == Loss::spilled;
  }
  if (lost.leaked + lost.spilled == 0) return lost;
  std::vector<int> kept;
  for (int i = 0; i < size; ++i)
    if (loss(i) == Loss::none) kept.push_back(i);
  s.reorder(kept);
  return lost;
}

}  // namespace seiche::solver
