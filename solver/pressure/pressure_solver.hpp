#pragma once
#include <memory>
#include <string>

#include "solver/pressure/pressure_system.hpp"

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

/// By name:
///  amg      conjugate gradients with aggregation multigrid, whose iterations don't grow with the tank (AmgSolver);
///  iccg     conjugate gradients with incomplete Cholesky (Eigen), the paper's;
///  sor      successive over-relaxation (omega = 1.5), the paper's other choice;
///  cholmod  sparse Cholesky factorisation (SuiteSparse), exact to rounding.
/// Throws std::invalid_argument for another name.
std::unique_ptr<PressureSolver> make_pressure_solver(const std::string& name, double tolerance, int max_iterations);

/// Version of CHOLMOD, as in "3.0.14".
std::string cholmod_version();

}  // namespace seiche::solver
