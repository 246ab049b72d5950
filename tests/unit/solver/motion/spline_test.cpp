#include "solver/motion/spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

/// Greatest errors of value, rate and acceleration over [0, 3] of the spline through samples of sin, spaced h but for
/// a ripple.
Jet errors_on_a_sine(int intervals, double ripple) {
  std::vector<double> x, y;
  for (int k = 0; k <= intervals; ++k) {
    const double s = 3.0 * k / intervals;
    x.push_back(s + ripple * std::sin(2 * M_PI * s / 3));
    y.push_back(std::sin(x.back()));
  }
  const Spline spline(x, y);
  Jet worst;
  for (double at = 0; at <= 3; at += 0.0007) {
    const Jet jet = spline.at(at);
    worst.value = std::max(worst.value, std::abs(jet.value - std::sin(at)));
    worst.rate = std::max(worst.rate, std::abs(jet.rate - std::cos(at)));
    worst.acceleration = std::max(worst.acceleration, std::abs(jet.acceleration + std::sin(at)));
  }
  return worst;
}

TEST(Spline, ConvergesOnASineToFourthThirdAndSecondOrder) {
  for (double ripple : {0.0, 0.2}) {
    const Jet coarse = errors_on_a_sine(100, ripple), fine = errors_on_a_sine(200, ripple);
    EXPECT_NEAR(std::log2(coarse.value / fine.value), 4, 0.3) << ripple;
    EXPECT_NEAR(std::log2(coarse.rate / fine.rate), 3, 0.3) << ripple;
    EXPECT_NEAR(std::log2(coarse.acceleration / fine.acceleration), 2, 0.3) << ripple;
  }
}

TEST(Spline, IsExactOnCubicsUpToAndBeyondItsEnds) {
  const auto cubic = [](double x) {
    return Jet{1 - 2 * x + 0.5 * x * x - 3 * x * x * x, -2 + x - 9 * x * x, 1 - 18 * x};
  };
  for (std::size_t samples : {4, 5, 9}) {
    std::vector<double> x, y;
    for (int k = 0; k < static_cast<int>(samples); ++k)
      x.push_back(0.3 * k + 0.02 * k * k), y.push_back(cubic(x.back()).value);
    const Spline spline(x, y);
    for (double at : {-0.1, 0.0, 0.01, 0.3, 0.5, x.back() - 0.01, x.back(), x.back() + 0.1}) {
      EXPECT_NEAR(spline.at(at).value, cubic(at).value, 1e-11) << samples << " samples, " << at;
      EXPECT_NEAR(spline.at(at).rate, cubic(at).rate, 1e-10);
      EXPECT_NEAR(spline.at(at).acceleration, cubic(at).acceleration, 1e-9);
    }
  }
}

TEST(Spline, PassesThroughItsSamplesWithoutAKink) {
  const std::vector<double> x{0, 0.1, 0.5, 0.6, 1.4, 1.5}, y{3, -1, 4, 1, -5, 9};
  const Spline spline(x, y);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(spline.at(x[k]).value, y[k], 1e-12);
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const Jet left = spline.at(x[k] - 1e-9), right = spline.at(x[k] + 1e-9);
    EXPECT_NEAR(left.rate, right.rate, 1e-4);
    EXPECT_NEAR(left.acceleration, right.acceleration, 1e-3);
  }
}

}  // namespace
}  // namespace seiche::solver
