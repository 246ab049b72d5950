#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "solver/amg_solver.hpp"
#include "tests/unit/solver/stirred_system.hpp"

// A program of its own, because it replaces operator new by one that counts.
namespace {
std::atomic<long> allocations{0};
}
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace seiche::solver {
namespace {

TEST(AmgSolver, AllocatesNothingOnceItHasSolvedASystemOfTheSize) {
  const test::StirredSystem<2> s({95, 32}), smaller({90, 30});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(s.rows()), y = Eigen::VectorXd::Zero(smaller.rows());
  AmgSolver solver(1e-6, 100);
  const long start = allocations;
  ASSERT_TRUE(solver.solve(s.matrix(), s.b, x).converged);
  const long first = allocations;
  EXPECT_GT(first, start);
  x.setZero();
  ASSERT_TRUE(solver.solve(s.matrix(), s.b, x).converged);
  ASSERT_TRUE(solver.solve(smaller.matrix(), smaller.b, y).converged);
  EXPECT_EQ(allocations, first);
}

}  // namespace
}  // namespace seiche::solver
