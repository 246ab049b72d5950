#include "solver/pressure/pressure_solver.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/IterativeLinearSolvers>

#include "solver/pressure/amg/amg_solver.hpp"

namespace seiche::solver {
namespace {

double relative_residual(const SparseView& a, const VectorIn& b, const VectorIn& x) {
  const double norm = b.norm();
  return norm > 0 ? (b - a * x).norm() / norm : x.norm();
}

class Iccg : public PressureSolver {
 public:
  Iccg(double tolerance, int max_iterations) {
    solver_.setTolerance(tolerance);
    solver_.setMaxIterations(max_iterations);
  }
  SolveReport solve(const SparseView& a, const VectorIn& b, VectorOut x) override {
    solver_.compute(a);
    if (solver_.info() != Eigen::Success) return {0, 1, false};
    x = solver_.solveWithGuess(b, x);
    return {static_cast<int>(solver_.iterations()), solver_.error(), solver_.info() == Eigen::Success};
  }

 private:
  // Particles are in cell order already: reordering them again costs more than it saves.
  using Cholesky = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper, Cholesky> solver_;
};

class Sor : public PressureSolver {
 public:
  Sor(double tolerance, int max_iterations) : tolerance_(tolerance), max_iterations_(max_iterations) {}
  SolveReport solve(const SparseView& a, const VectorIn& b, VectorOut x) override {
    // omega = 1.5: over-relaxation converges for every 0 < omega < 2 (Ostrowski 1954); the best one grows towards 2
    // with the tank, this one is safe.
    constexpr double omega = 1.5;
    SolveReport report{0, relative_residual(a, b, x), false};
    while (!(report.residual <= tolerance_) && report.iterations < max_iterations_) {
      for (int i = 0; i < a.rows(); ++i) {
        double sum = b[i], diagonal = 1;
        for (SparseView::InnerIterator it(a, i); it; ++it) {
          if (it.col() == i) diagonal = it.value();
          sum -= it.value() * x[it.col()];
        }
        x[i] += omega * sum / diagonal;
      }
      ++report.iterations;
      report.residual = relative_residual(a, b, x);
    }
    report.converged = report.residual <= tolerance_;
    return report;
  }

 private:
  double tolerance_;
  int max_iterations_;
};

class Cholmod : public PressureSolver {
 public:
  SolveReport solve(const SparseView& a, const VectorIn& b, VectorOut x) override {
    // The matrix is symmetric, so its rows serve as the columns that CHOLMOD wants.
    const Eigen::Map<const Eigen::SparseMatrix<double>> columns(a.rows(), a.cols(), a.nonZeros(), a.outerIndexPtr(),
                                                                a.innerIndexPtr(), a.valuePtr());
    solver_.compute(columns);
    if (solver_.info() != Eigen::Success) return {0, 1, false};
    x = solver_.solve(b);
    const double residual = relative_residual(a, b, x);
    return {1, residual, residual < 1e-8};
  }

 private:
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace

std::unique_ptr<PressureSolver> make_pressure_solver(SolverName name, double tolerance, int max_iterations) {
  switch (name) {
    case SolverName::iccg:
      return std::make_unique<Iccg>(tolerance, max_iterations);
    case SolverName::sor:
      return std::make_unique<Sor>(tolerance, max_iterations);
    case SolverName::cholmod:
      return std::make_unique<Cholmod>();
    case SolverName::amg:
      break;
  }
  return std::make_unique<AmgSolver>(tolerance, max_iterations);
}

std::string cholmod_version() {
  int version[3];
  ::cholmod_version(version);
  return std::to_string(version[0]) + "." + std::to_string(version[1]) + "." + std::to_string(version[2]);
}

}  // namespace seiche::solver
