#pragma once
#include "solver/pressure/amg/amg_matrix.hpp"

namespace seiche::solver {

/// Cholesky factorisation A = L L^T within the skyline, from each row's first link to its diagonal (Jennings 1966), for
/// the coarsest level: rows come in cell order, so the skyline is low, and buffers are kept.
class Skyline {
 public:
  /// Where A is singular, the unknown at which that shows becomes 0.
  void factorise(const AmgMatrix& a);
  void solve(const double* b, double* x);

 private:
  /// Row i of L, to be indexed by columns first_[i] .. i.
  double* row(int i) { return value_.data() + start_[i] - first_[i]; }

  int rows_ = 0;
  std::vector<int> first_, start_;
  std::vector<double> value_;
  std::vector<double> inverse_;  ///< 1/l_ii
  std::vector<double> work_;
};

}  // namespace seiche::solver
