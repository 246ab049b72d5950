#include "solver/pressure/amg/amg_solver.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "solver/pressure/pressure_solver.hpp"
#include "tests/unit/solver/stirred_system.hpp"

namespace seiche::solver {
namespace {

using test::StirredSystem;

template <class System>
int iterations(const System& s, double tolerance) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(s.rows());
  const SolveReport report = AmgSolver(tolerance, 100).solve(s.matrix(), s.b, x);
  EXPECT_TRUE(report.converged);
  EXPECT_LE((s.b - s.matrix() * x).norm(), 1.001 * tolerance * s.b.norm());
  return report.iterations;
}

SparseView view(const SparseMatrix& a) {
  return {a.rows(), a.cols(), a.nonZeros(), a.outerIndexPtr(), a.innerIndexPtr(), a.valuePtr()};
}

template <int D>
void expect_cholmods_answer(const StirredSystem<D>& s) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(s.rows()), exact = Eigen::VectorXd::Zero(s.rows());
  ASSERT_TRUE(make_pressure_solver(SolverName::cholmod, 0, 0)->solve(s.matrix(), s.b, exact).converged);
  EXPECT_TRUE(AmgSolver(1e-12, 100).solve(s.matrix(), s.b, x).converged);
  EXPECT_LT((x - exact).norm(), 1e-9 * exact.norm());
}

TEST(AmgSolver, FindsCholmodsAnswer) {
  expect_cholmods_answer(StirredSystem<2>({100, 40}));
  expect_cholmods_answer(StirredSystem<3>({18, 12, 15}));
}

TEST(AmgSolver, NeedsNoMoreIterationsInALargerTank) {
  for (const auto& [x, y] : {std::pair(95, 32), std::pair(190, 63), std::pair(387, 129), std::pair(1095, 365)}) {
    SCOPED_TRACE(x * y);
    const StirredSystem<2> s({x, y});
    EXPECT_LE(iterations(s, 1e-6), 12);
    EXPECT_LE(iterations(s, 1e-4), 9);
  }
  for (const auto& [x, y, z] : {std::tuple(22, 12, 11), std::tuple(60, 28, 30)}) {
    SCOPED_TRACE(x * y * z);
    EXPECT_LE(iterations(StirredSystem<3>({x, y, z}), 1e-6), 11);
  }
}

TEST(AmgSolver, SolvesAPerfectLatticeAndAWildOne) {
  for (double stir : {0., 0.05, 0.1, 0.2, 0.3}) {
    SCOPED_TRACE(stir);
    EXPECT_LE(iterations(StirredSystem<2>({190, 63}, stir), 1e-6), 12);
  }
}

TEST(AmgSolver, SolvesAFullTankWhichIsNearlySingular) {
  EXPECT_LE(iterations(StirredSystem<2>({190, 63}, 0.15, true), 1e-6), 13);
  EXPECT_LE(iterations(StirredSystem<3>({22, 12, 11}, 0.15, true), 1e-6), 13);
}

TEST(AmgSolver, SolvesASingularSystemThatHasAnAnswer) {
  StirredSystem<2> s({95, 32}, 0.15, true, 0);
  s.b.array() -= s.b.mean();
  EXPECT_LE(iterations(s, 1e-6), 13);
}

TEST(AmgSolver, SolvesScatteredDropsAndLoneParticles) {
  // Chains of 1 to 7 rows, each regular by itself; the first of them are alone.
  std::vector<Eigen::Triplet<double>> entries;
  int rows = 0;
  for (int k = 0; k < 700; ++k)
    for (int n = 0; n < k / 100 + 1; ++n, ++rows) {
      entries.emplace_back(rows, rows, 2.1);
      if (n == 0) continue;
      entries.emplace_back(rows, rows - 1, -1);
      entries.emplace_back(rows - 1, rows, -1);
    }
  SparseMatrix a(rows, rows);
  a.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(rows, -1, 2);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(rows);
  const SolveReport report = AmgSolver(1e-10, 100).solve(view(a), b, x);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.iterations, 20);

  SparseMatrix alone(2000, 2000);
  alone.setIdentity();
  x = Eigen::VectorXd::Zero(2000);
  EXPECT_EQ(AmgSolver(1e-10, 100).solve(view(alone), Eigen::VectorXd::Ones(2000), x).iterations, 1);
  EXPECT_EQ(x, Eigen::VectorXd::Ones(2000));
}

TEST(AmgSolver, AnswersNothingToNothing) {
  const SparseMatrix a(0, 0);
  Eigen::VectorXd x(0);
  const SolveReport report = AmgSolver(1e-6, 100).solve(view(a), Eigen::VectorXd(0), x);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
}

TEST(AmgSolver, DoesNotConvergeOnWhatIsNotFinite) {
  StirredSystem<2> s({30, 20});
  s.b[7] = std::nan("");
  Eigen::VectorXd x = Eigen::VectorXd::Zero(s.rows());
  const SolveReport report = AmgSolver(1e-6, 100).solve(s.matrix(), s.b, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 0);
}

TEST(AmgSolver, GivesTheSameBytesForEveryNumberOfThreads) {
  const int before = omp_get_max_threads();
  const StirredSystem<2> s({190, 63});
  Eigen::VectorXd first;
  for (int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(s.rows());
    EXPECT_TRUE(AmgSolver(1e-8, 100).solve(s.matrix(), s.b, x).converged);
    if (threads == 1) first = x;
    EXPECT_EQ(x, first) << threads;
  }
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace seiche::solver
