#include "solver/modes/closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

using std::numbers::pi;

void check_positive(const char* what, double value, const char* unit) {
  if (!(value > 0) || !std::isfinite(value))
    throw BadParameters(
        fmt::format("first frequencies: the {} is {:.6g} {}; it must be greater than 0", what, value, unit));
}

/// The first frequencies of waves with these wave numbers [1/m].
std::vector<double> frequencies(std::vector<double> wave_numbers, double depth, double gravity, int count) {
  std::sort(wave_numbers.begin(), wave_numbers.end());
  wave_numbers.resize(std::min(wave_numbers.size(), static_cast<std::size_t>(count)));
  for (double& k : wave_numbers) k = std::sqrt(gravity * k * std::tanh(k * depth));
  return wave_numbers;
}

/// J_m'
double bessel_slope(int m, double x) {
  if (m == 0) return -std::cyl_bessel_j(1.0, x);
  return 0.5 * (std::cyl_bessel_j(m - 1.0, x) - std::cyl_bessel_j(m + 1.0, x));
}

}  // namespace

std::vector<double> bessel_slope_zeros(int m, int count) {
  // The first is beyond m (and 1), and those after it are more than 1 apart (DLMF 10.21).
  constexpr double step = 0.25;
  std::vector<double> zeros;
  double low = std::max(m, 1);
  while (zeros.size() < static_cast<std::size_t>(count)) {
    double a = low, b = low + step;
    low = b;
    const bool rises = bessel_slope(m, a) < 0;
    if (rises == (bessel_slope(m, b) < 0)) continue;
    while (b - a > 1e-14 * b) {
      const double middle = 0.5 * (a + b);
      if (middle <= a || middle >= b) break;
      (rises == (bessel_slope(m, middle) < 0) ? a : b) = middle;
    }
    zeros.push_back(0.5 * (a + b));
  }
  return zeros;
}

std::vector<double> box_frequencies(const std::vector<double>& sides, double depth, double gravity, int count) {
  for (const double side : sides) check_positive("length of the still surface", side, "m");
  check_positive("depth", depth, "m");
  check_positive("gravity", gravity, "m/s^2");
  std::vector<double> wave_numbers;
  for (int n = 0; n <= count; ++n) {
    if (sides.size() == 1 && n > 0) wave_numbers.push_back(n * pi / sides[0]);
    for (int m = 0; sides.size() > 1 && m <= count; ++m)
      if (n + m > 0) wave_numbers.push_back(pi * std::hypot(n / sides[0], m / sides[1]));
  }
  return frequencies(std::move(wave_numbers), depth, gravity, count);
}

std::vector<double> upright_cylinder_frequencies(double radius, double depth, double gravity, int count) {
  check_positive("radius", radius, "m");
  check_positive("depth", depth, "m");
  check_positive("gravity", gravity, "m/s^2");
  std::vector<double> wave_numbers;
  // The first zero of J_m' is beyond m, and that of m + 1 is less than 2 beyond it.
  for (int m = 0; m <= 2 * count; ++m)
    for (const double zero : bessel_slope_zeros(m, count)) wave_numbers.push_back(zero / radius);
  return frequencies(std::move(wave_numbers), depth, gravity, count);
}

}  // namespace seiche::solver::modes
