#include "solver/operators/kernels.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

constexpr double r_e = 2;

template <class F>
void each_kernel(F f) {
  for (const Kernel& kernel : kernel_table(r_e)) {
    SCOPED_TRACE(std::string(name(kernel)));
    std::visit(f, kernel);
  }
}

TEST(Kernels, HaveTheValuesOfTableOne) {
  EXPECT_DOUBLE_EQ(KF1{r_e}(0.5), 3);
  EXPECT_DOUBLE_EQ(KF1{r_e}(1), 1);
  EXPECT_DOUBLE_EQ(KF1{r_e}(1.5), 1. / 3);
  EXPECT_DOUBLE_EQ(KF2{r_e}(0), 1);
  EXPECT_DOUBLE_EQ(KF2{r_e}(1), std::exp(-1. / 36));
  EXPECT_DOUBLE_EQ((KF2{r_e, 0.5}(1)), std::exp(-1.));
  EXPECT_DOUBLE_EQ(KF3{r_e}(0), 1);
  EXPECT_DOUBLE_EQ(KF3{r_e}(0.5), 189. / 256);
  EXPECT_DOUBLE_EQ(KF3{r_e}(1), 5. / 16);
  EXPECT_DOUBLE_EQ(KF4{r_e}(0), 2. / 3);
  EXPECT_DOUBLE_EQ(KF4{r_e}(0.5), 23. / 48);
  EXPECT_DOUBLE_EQ(KF4{r_e}(1), 1. / 6);
  EXPECT_DOUBLE_EQ(KF4{r_e}(1.5), 1. / 48);
  EXPECT_DOUBLE_EQ(KF5{r_e}(0), 2);
  EXPECT_DOUBLE_EQ(KF5{r_e}(0.5), 7. / 4);
  EXPECT_DOUBLE_EQ(KF5{r_e}(1), 1);
  EXPECT_DOUBLE_EQ(KF5{r_e}(1.5), 1. / 4);
}

TEST(Kernels, EndAtTheSupport) {
  each_kernel([](const auto& w) {
    EXPECT_GT(w(r_e * (1 - 1e-3)), 0);
    for (double r : {r_e * (1 + 1e-12), 1.5 * r_e, 100 * r_e}) EXPECT_EQ(w(r), 0);
  });
}

TEST(Kernels, ArePositiveAndFallAllTheWay) {
  each_kernel([](const auto& w) {
    constexpr int steps = 200;
    for (int k = 1; k < steps; ++k) {
      const double r = r_e * k / steps;
      EXPECT_GT(w(r), 0) << r;
      EXPECT_LT(w(r), w(r - r_e / steps)) << r;
    }
  });
}

TEST(Kernels, DependOnTheShareOfTheSupportOnly) {
  each_kernel([](auto w) {
    auto twice = w;
    twice.support *= 2;
    for (double r : {0.3, 0.9, 1.1, 1.9}) EXPECT_DOUBLE_EQ(twice(2 * r), w(r));
  });
}

TEST(Kernels, AllButKF2EndInZero) {
  each_kernel([](const auto& w) {
    if (w.name == "KF2") return;
    { EXPECT_LT(w(r_e * (1 - 1e-9)), 1.1e-9); }
  });
}

TEST(Kernels, KF2JumpsAtTheSupport) {
  EXPECT_DOUBLE_EQ(KF2{r_e}(r_e), std::exp(-1. / 9));
  EXPECT_NEAR(KF2{r_e}(r_e), 0.895, 5e-4);
  EXPECT_NEAR((KF2{r_e, 1. / 3}(r_e)), 1.2e-4, 5e-6) << "with alpha = 1/3 there is hardly a jump";
}

TEST(Kernels, SplinesJoinWithTheirSlopeAtHalfTheSupport) {
  const auto check = [](const auto& w, double value, double slope) {
    constexpr double half = r_e / 2, h = 1e-6;
    EXPECT_NEAR(w(half - h), w(half), 1.1 * h * -slope);
    EXPECT_NEAR(w(half + h), w(half), 1.1 * h * -slope);
    EXPECT_DOUBLE_EQ(w(half), value);
    EXPECT_NEAR((w(half) - w(half - h)) / h, slope, 1e-5);
    EXPECT_NEAR((w(half + h) - w(half)) / h, slope, 1e-5);
  };
  check(KF4{r_e}, 1. / 6, -0.5);  // dw/dq = -8 q + 12 q^2 = -1
  check(KF5{r_e}, 1, -2);         // dw/dq = -8 q = -4
}

TEST(Kernels, BothFormsOfKF3AreOne) {
  for (double q = 0; q < 1; q += 1. / 64)
    EXPECT_NEAR(KF3{r_e}(q * r_e), 1 - 6 * q * q + 8 * q * q * q - 3 * q * q * q * q, 1e-15) << q;
}

TEST(Kernels, TableNamesThemInOrder) {
  const auto table = kernel_table(r_e, 0.7);
  ASSERT_EQ(table.size(), 5u);
  for (std::size_t k = 0; k < table.size(); ++k) EXPECT_EQ(name(table[k]), "KF" + std::to_string(k + 1));
  for (const Kernel& kernel : table) EXPECT_EQ(std::visit([](const auto& w) { return w.support; }, kernel), r_e);
  EXPECT_EQ(std::get<KF2>(table[1]).alpha, 0.7);
}

}  // namespace
}  // namespace seiche::solver
