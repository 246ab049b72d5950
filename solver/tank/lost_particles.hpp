#pragma once
#include "solver/tank/tank.hpp"

namespace seiche::solver {

/// Fluid particles that left the tank.
struct Lost {
  long leaked = 0;   ///< through a wall
  long spilled = 0;  ///< over the rim of an open tank
};

/// Removes them from the state, and counts them.
template <int D>
Lost take_out_lost(const Box<D>& box, State<D>& s) {
  const auto spilled = [&](int i) { return s.kind[i] == Kind::fluid && box.has_spilled(s.position[i]); };
  const auto leaked = [&](int i) { return s.kind[i] == Kind::fluid && box.has_leaked(s.position[i]); };
  const int size = static_cast<int>(s.size());
  Lost lost;
  for (int i = 0; i < size; ++i)
    if (spilled(i))
      ++lost.spilled;
    else if (leaked(i))
      ++lost.leaked;
  if (lost.leaked + lost.spilled == 0) return lost;
  std::vector<int> kept;
  for (int i = 0; i < size; ++i)
    if (!spilled(i) && !leaked(i)) kept.push_back(i);
  s.reorder(kept);
  return lost;
}

}  // namespace seiche::solver
