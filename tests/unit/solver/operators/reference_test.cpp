#include "solver/operators/reference.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"

namespace seiche::solver {
namespace {

constexpr double l0 = 0.01;

/// Lattice points at one distance: squared distance over l0^2, and how many.
struct Shell {
  int r2, points;
};

template <int D>
std::vector<Shell> shells() {
  if constexpr (D == 2) return {{1, 4}, {2, 4}, {4, 4}, {5, 8}, {8, 4}, {9, 4}};
  return {{1, 6}, {2, 12}, {3, 8}, {4, 6}, {5, 24}, {6, 24}, {8, 12}, {9, 30}};
}

template <int D>
void expect_sums_over_shells(double radius, int count) {
  for (const Kernel& kernel : kernel_table(radius * l0)) {
    const Reference ref = std::visit([](const auto& w) { return lattice_reference<D>(w, l0); }, kernel);
    double n0 = 0, moment = 0;
    for (const Shell& shell : shells<D>()) {
      const double r = l0 * std::sqrt(shell.r2);
      const double w = std::visit([&](const auto& k) { return k(r); }, kernel);
      n0 += shell.points * w;
      moment += shell.points * w * r * r;
    }
    EXPECT_NEAR(ref.n0, n0, 1e-13 * n0) << name(kernel) << ", r_e = " << radius << ", " << D << "-D";
    EXPECT_NEAR(ref.lambda, moment / n0, 1e-13 * moment) << name(kernel) << ", r_e = " << radius << ", " << D << "-D";
    EXPECT_EQ(ref.count, count) << name(kernel) << ", r_e = " << radius << ", " << D << "-D";
  }
}

TEST(Reference, OfKF3IsTheHandSum) {
  const KF3 w{2.1 * l0};
  const double w1 = w(l0), w2 = w(std::sqrt(2) * l0), w4 = w(2 * l0);
  const Reference ref = lattice_reference<2>(w, l0);
  EXPECT_NEAR(ref.n0, 4 * w1 + 4 * w2 + 4 * w4, 1e-14);
  EXPECT_NEAR(ref.lambda, l0 * l0 * (4 * w1 + 8 * w2 + 16 * w4) / ref.n0, 1e-18);
  EXPECT_EQ(ref.count, 12);
}

TEST(Reference, OfEveryKernelIsTheSumOverShells) {
  expect_sums_over_shells<2>(2.1, 12);
  expect_sums_over_shells<2>(2.6, 20);
  expect_sums_over_shells<2>(3.1, 28);
  expect_sums_over_shells<3>(2.1, 32);
  expect_sums_over_shells<3>(2.6, 80);
  expect_sums_over_shells<3>(3.1, 122);
}

TEST(Reference, OfALineCountsItsTwoSides) {
  const KF5 w{2.6};
  const Reference ref = lattice_reference<1>(w, 1);
  EXPECT_DOUBLE_EQ(ref.n0, 2 * w(1) + 2 * w(2));
  EXPECT_EQ(ref.count, 4);
}

TEST(Reference, LeavesOutWhatLiesAtTheSupportItself) {
  EXPECT_EQ(lattice_reference<2>(KF2{2}, 1).count, 8);  // four more lie at r = r_e, where KF2 isn't zero
  EXPECT_DOUBLE_EQ(lattice_reference<2>(KF2{2}, 1).n0, 4 * KF2{2}(1) + 4 * KF2{2}(std::sqrt(2)));
}

TEST(Reference, ScalesWithTheSpacing) {
  const Reference small = lattice_reference<3>(KF3{2.6 * l0}, l0), large = lattice_reference<3>(KF3{26 * l0}, 10 * l0);
  EXPECT_NEAR(large.n0, small.n0, 1e-12 * small.n0);
  EXPECT_NEAR(large.lambda, 100 * small.lambda, 1e-10 * small.lambda);
}

}  // namespace
}  // namespace seiche::solver
