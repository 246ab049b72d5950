#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "solver/make_simulation.hpp"
#include "solver/pressure/amg/amg_solver.hpp"
#include "tests/unit/solver/still_tank.hpp"
#include "tests/unit/solver/stirred_system.hpp"

// A program of its own, because it replaces malloc by one that counts, which Eigen and operator new both end at. The
// sanitizers have a malloc of their own: there only operator new is counted.
namespace {
std::atomic<long> allocations{0};
}
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#else
// NOLINTBEGIN(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name): the C library's own
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_realloc(void*, std::size_t);
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* realloc(void* p, std::size_t size) {
  ++allocations;
  return __libc_realloc(p, size);
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name)
#endif

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

void expect_steps_without_allocations(Parameters p) {
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.03, 1}};
  const auto simulation = make_simulation(p, 0);
  const auto take = [&](int steps) {
    for (int k = 0; k < steps; ++k) simulation->step(100);
  };
  take(80);
  const long before = allocations, lists = simulation->statistics().list_builds;
  take(40);
  EXPECT_EQ(allocations, before);
  EXPECT_GT(simulation->statistics().list_builds, lists) << "the steps made no list";
}

TEST(Step, AllocatesNothingOnceBuffersHaveTheirSizeIn2D) { expect_steps_without_allocations(test::small_tank<2>()); }

TEST(Step, AllocatesNothingOnceBuffersHaveTheirSizeIn3D) { expect_steps_without_allocations(test::small_tank<3>()); }

}  // namespace
}  // namespace seiche::solver
