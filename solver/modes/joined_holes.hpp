#pragma once
#include <vector>

#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// An outline as one closed walk over its corners, the liquid on the left.
struct Walk {
  std::vector<Corner> corners;
  std::vector<int> order;  ///< places in `corners`; those at the ends of the cuts come twice
};

/// Joins the holes to the outer loop by cuts, there and back, that cross nothing. Throws BadParameters where there is
/// no such cut, which means that loops cross or touch each other.
Walk joined(const Outline& outline);

}  // namespace seiche::solver::modes
