#pragma once
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// Calls f(i) for every fluid particle, by several threads.
template <int D, class F>
void each_fluid(const State<D>& s, F f) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i)
    if (s.kind[i] == Kind::fluid) f(i);
}

}  // namespace seiche::solver
