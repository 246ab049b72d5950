#include "solver/modes/closed_forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

using std::numbers::pi;

TEST(ClosedForms, ZerosOfTheSlopeOfBesselFunctions) {
  // Abramowitz & Stegun 1964, table 9.5.
  const std::vector<std::vector<double>> table{{3.83170597, 7.01558667, 10.17346814},
                                               {1.84118378, 5.33144277, 8.53631637},
                                               {3.05423693, 6.70613319, 9.96946782},
                                               {4.20118894, 8.01523660, 11.34592431}};
  for (int m = 0; m < 4; ++m) {
    const auto zeros = bessel_slope_zeros(m, 3);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(zeros[k], table[static_cast<std::size_t>(m)][k], 1e-8);
  }
}

TEST(ClosedForms, ZerosOfHighOrderComeInPlace) {
  // Zeros of J_m' and J_(m+1)' lie between each other; the first is near m + 0.8086165 m^(1/3) (DLMF 10.21.40).
  for (int m = 1; m < 60; ++m) {
    const auto zeros = bessel_slope_zeros(m, 3), next = bessel_slope_zeros(m + 1, 3);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(zeros[k], next[k]);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(next[k], zeros[k + 1]);
    EXPECT_NEAR(zeros[0], m + 0.8086165 * std::cbrt(m) + 0.0724902 / std::cbrt(m), 0.1 / m);
  }
}

TEST(ClosedForms, BoxIn2D) {
  const auto all = box_frequencies({0.5}, 0.2, 9.81, 5);
  ASSERT_EQ(all.size(), 5u);
  // Reference eigenfrequencies: modes 1, 3 and 5.
  EXPECT_NEAR(all[0], 7.23883, 1e-5);
  EXPECT_NEAR(all[2], 13.59109, 1e-5);
  EXPECT_NEAR(all[4], 17.55529, 1e-5);
}

TEST(ClosedForms, BoxIn3DHasWavesBothWaysAndAcross) {
  const double h = 0.25, g = 9.81;
  const auto wave = [&](double n, double m) {
    const double k = pi * std::hypot(n / 0.5, m / 0.4);
    return std::sqrt(g * k * std::tanh(k * h));
  };
  std::vector<double> expected;
  for (int n = 0; n < 8; ++n)
    for (int m = 0; m < 8; ++m)
      if (n + m > 0) expected.push_back(wave(n, m));
  std::sort(expected.begin(), expected.end());
  const auto all = box_frequencies({0.5, 0.4}, h, g, 7);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(all[k], expected[k], 1e-12);
}

TEST(ClosedForms, ShallowAndDeepWater) {
  const double length = 1, g = 9.81;
  EXPECT_NEAR(box_frequencies({length}, 1e-3, g, 1)[0], pi / length * std::sqrt(g * 1e-3), 1e-5 * 0.3);
  EXPECT_NEAR(box_frequencies({length}, 10, g, 1)[0], std::sqrt(g * pi / length), 1e-12);
}

TEST(ClosedForms, UprightCylinderFromItsFirstZeros) {
  const double radius = 0.25, h = 0.25, g = 9.81;
  const auto all = upright_cylinder_frequencies(radius, h, g, 5);
  const std::vector<double> zeros{1.841184, 3.054237, 3.831706, 4.201189, 5.317553};
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(all[k], std::sqrt(g * zeros[k] / radius * std::tanh(zeros[k] * h / radius)), 1e-5);
}

TEST(ClosedForms, RefusesWhatIsNotPositive) {
  EXPECT_THROW(box_frequencies({0.5}, 0, 9.81, 1), BadParameters);
  EXPECT_THROW(box_frequencies({0.5, -1}, 0.1, 9.81, 1), BadParameters);
  EXPECT_THROW(upright_cylinder_frequencies(0, 0.1, 9.81, 1), BadParameters);
  EXPECT_THROW(upright_cylinder_frequencies(1, 0.1, 0, 1), BadParameters);
}

}  // namespace
}  // namespace seiche::solver::modes
