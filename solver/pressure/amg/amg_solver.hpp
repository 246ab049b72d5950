#pragma once
#include "solver/pressure/amg/amg.hpp"
#include "solver/pressure/linear_solver.hpp"

namespace seiche::solver {

/// Flexible conjugate gradients (Polak-Ribiere form; Notay 2000), preconditioned by aggregation multigrid. The same
/// bytes for every number of threads.
class AmgSolver : public PressureSolver {
 public:
  AmgSolver(double tolerance, int max_iterations) : tolerance_(tolerance), max_iterations_(max_iterations) {}
  SolveReport solve(const SparseView& a, const VectorIn& b, VectorOut x) override;

 private:
  double tolerance_;
  int max_iterations_;
  Amg amg_;
  ChunkSums sums_;
  std::vector<double> residual_, corrected_, direction_, image_;
};

}  // namespace seiche::solver
