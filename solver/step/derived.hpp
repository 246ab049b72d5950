#pragma once
#include <algorithm>

#include "solver/operators/vorticity.hpp"
#include "solver/particles/pairs.hpp"
#include "solver/quantity.hpp"

namespace seiche::solver {

/// Adds to a frame of the state what no step needs, quantities that are null in their table.
/// @param pairs of a kernel with the initial lattice's number density n0, at the state's positions
template <int D>
void derive(const Pairs<D>& pairs, double n0, const State<D>& s, Frame& frame) {
  const auto add = [&](Quantity quantity, const Scalars& values) {
    std::vector<float> in_frame(frame.size());
    for (std::size_t i = 0; i < s.size(); ++i)
      in_frame[std::ranges::lower_bound(frame.id, s.id[i]) - frame.id.begin()] = static_cast<float>(values[i]);
    frame.derived.push_back({quantity, std::move(in_frame)});
  };
  add(Quantity::vorticity, vorticity(pairs, n0, s));
}

}  // namespace seiche::solver
