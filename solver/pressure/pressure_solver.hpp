#pragma once
#include <memory>
#include <string>

#include "solver/choice.hpp"
#include "solver/pressure/linear_solver.hpp"

namespace seiche::solver {

/// By name:
///  amg      conjugate gradients with aggregation multigrid, whose iterations don't grow with the tank (AmgSolver);
///  iccg     conjugate gradients with incomplete Cholesky (Eigen), the paper's;
///  sor      successive over-relaxation (omega = 1.5), the paper's other choice;
///  cholmod  sparse Cholesky factorisation (SuiteSparse), exact to rounding.
std::unique_ptr<PressureSolver> make_pressure_solver(SolverName name, double tolerance, int max_iterations);

/// Version of CHOLMOD, as in "3.0.14".
std::string cholmod_version();

}  // namespace seiche::solver
