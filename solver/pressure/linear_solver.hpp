#pragma once
#include <Eigen/Core>

#include "solver/pressure/sparse_matrix.hpp"

namespace seiche::solver {

struct SolveReport {
  int iterations = 0;
  double residual = 0;  ///< |b - A x| / |b|, 2-norms
  bool converged = false;
};

/// Vectors that a solver reads, and writes into: Eigen's, or views of them.
using VectorIn = Eigen::Ref<const Eigen::VectorXd>;
using VectorOut = Eigen::Ref<Eigen::VectorXd>;

/// Solves A x = b, A symmetric positive definite; x holds the first guess on entry.
class PressureSolver {
 public:
  virtual ~PressureSolver() = default;
  virtual SolveReport solve(const SparseView& a, const VectorIn& b, VectorOut x) = 0;
};

}  // namespace seiche::solver
