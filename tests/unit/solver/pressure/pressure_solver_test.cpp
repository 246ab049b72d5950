#include "solver/pressure/pressure_solver.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

/// The pressure equation of a tank at rest, with a source that isn't smooth on the right-hand side.
struct Solvers : ::testing::TestWithParam<SolverName> {
  PressureSystem<2> system;
  Eigen::VectorXd b, exact;

  Solvers() {
    test::StillTank<2> tank;
    tank.set_surface_pressure();
    system = tank.system(tank.ghost(), 1e-7 * tank.ref.n0);
    b = system.rhs();
    for (int k = 0; k < b.size(); ++k) b[k] += 10 * std::sin(k);
    exact = Eigen::VectorXd::Zero(b.size());
    EXPECT_TRUE(make_pressure_solver(SolverName::cholmod, 0, 0)->solve(system.matrix(), b, exact).converged);
  }

  double residual(const Eigen::VectorXd& x) const { return (b - system.matrix() * x).norm() / b.norm(); }
};

struct IterativeSolvers : Solvers {};

INSTANTIATE_TEST_SUITE_P(, IterativeSolvers, ::testing::Values(SolverName::amg, SolverName::iccg, SolverName::sor),
                         [](const auto& test) { return std::string(name(test.param)); });
INSTANTIATE_TEST_SUITE_P(, Solvers,
                         ::testing::Values(SolverName::amg, SolverName::iccg, SolverName::sor, SolverName::cholmod),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(Solvers, FindTheExactAnswer) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const auto report = make_pressure_solver(GetParam(), 1e-11, 5000)->solve(system.matrix(), b, x);
  EXPECT_TRUE(report.converged);
  EXPECT_GT(report.iterations, 0);
  EXPECT_LT((x - exact).norm(), 1e-9 * exact.norm());
}

TEST_P(Solvers, StopAtTheToleranceAndReportTheTrueResidual) {
  for (double tolerance : {1e-2, 1e-4, 1e-6}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    const auto report = make_pressure_solver(GetParam(), tolerance, 5000)->solve(system.matrix(), b, x);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(residual(x), tolerance * (1 + 1e-6));
    EXPECT_NEAR(report.residual, residual(x), 1e-6 * residual(x) + 1e-12);
  }
}

TEST_P(IterativeSolvers, NeedFewerIterationsForLess) {
  int last = 0;
  for (double tolerance : {1e-2, 1e-5, 1e-8}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    const int iterations = make_pressure_solver(GetParam(), tolerance, 5000)->solve(system.matrix(), b, x).iterations;
    EXPECT_GT(iterations, last);
    last = iterations;
  }
}

TEST_P(IterativeSolvers, StartFromTheGuess) {
  Eigen::VectorXd x = exact;
  const auto report = make_pressure_solver(GetParam(), 1e-8, 5000)->solve(system.matrix(), b, x);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ((x - exact).norm(), 0);
}

TEST_P(IterativeSolvers, SayWhenTheyDidNotConverge) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const auto report = make_pressure_solver(GetParam(), 1e-11, 1)->solve(system.matrix(), b, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_NEAR(report.residual, residual(x), 1e-9);
  EXPECT_GT(report.residual, 1e-11);
}

TEST_P(Solvers, AnswerZeroToZero) {
  b.setZero();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(b.size());
  EXPECT_TRUE(make_pressure_solver(GetParam(), 1e-8, 5000)->solve(system.matrix(), b, x).converged);
  EXPECT_LT(x.norm(), 1e-7);
}

TEST_P(Solvers, CanBeUsedAgainOnAnotherSystem) {
  const auto solver = make_pressure_solver(GetParam(), 1e-11, 5000);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  ASSERT_TRUE(solver->solve(system.matrix(), b, x).converged);
  SparseMatrix small(2, 2);
  small.coeffRef(0, 0) = small.coeffRef(1, 1) = 2;
  small.coeffRef(0, 1) = small.coeffRef(1, 0) = -1;
  small.makeCompressed();
  const SparseView view(2, 2, 4, small.outerIndexPtr(), small.innerIndexPtr(), small.valuePtr());
  x = Eigen::VectorXd::Zero(2);
  EXPECT_TRUE(solver->solve(view, Eigen::Vector2d(0, 3), x).converged);
  EXPECT_NEAR(x[0], 1, 1e-9);
  EXPECT_NEAR(x[1], 2, 1e-9);
}

}  // namespace
}  // namespace seiche::solver
