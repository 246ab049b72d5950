#pragma once
#include "solver/pressure/amg/aggregation.hpp"

namespace seiche::solver {

/// The next level's matrix P^T A P, P_ig = 1 where row i belongs to aggregate g and 0 elsewhere.
class Galerkin {
 public:
  void form(const AmgMatrix& a, const Aggregates& p, AmgMatrix& coarse);

 private:
  /// What a thread gathers of one row of the coarse matrix; on cache lines of its own.
  struct alignas(64) Gathered {
    std::vector<int> place;  ///< of each column in the two below; -1: not met in this row
    std::vector<int> column;
    std::vector<float> weight;
  };
  std::vector<Gathered> gathered_;
  std::vector<int> room_;
};

}  // namespace seiche::solver
