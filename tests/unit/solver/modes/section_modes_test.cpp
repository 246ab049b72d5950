#include "solver/modes/section_modes.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "solver/errors.hpp"
#include "solver/modes/closed_forms.hpp"
#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

using std::numbers::pi;
constexpr double g = 9.81;

/// omega^2 / g of the first modes [1/m], of tanks of one chamber.
std::vector<double> eigenvalues(const Polygons& section, double level, int count, const Across& across = {}) {
  const auto chambers = section_modes(section, level, g, count, across);
  EXPECT_EQ(chambers.size(), 1u);
  std::vector<double> all;
  for (const Mode& mode : chambers[0].modes) all.push_back(mode.frequency * mode.frequency / g);
  return all;
}

/// Expects the antisymmetric modes, every other one from the first; figures are the reference eigenfrequencies' K =
/// omega^2/g.
void expect_antisymmetric(const Polygons& section, double level, const std::vector<double>& expected) {
  const auto all = eigenvalues(section, level, 5);
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(all[2 * k] / expected[k], 1, 1e-4) << k;
}

TEST(SectionModes, OfABoxAreOfTheFourthOrder) {
  std::vector<double> last;
  for (const int along : {8, 16, 32, 64}) {
    const auto modes = section_modes(test::box(0.5, 0.3), 0.2, g, 3, {}, along)[0].modes;
    const auto exact = box_frequencies({0.5}, 0.2, g, 3);
    std::vector<double> errors;
    for (std::size_t k = 0; k < 3; ++k) errors.push_back(modes[k].frequency / exact[k] - 1);
    // From above, as Rayleigh's quotient has it.
    for (const double error : errors) EXPECT_GT(error, 0);
    for (std::size_t k = 0; along > 16 && k < 3; ++k) EXPECT_GT(std::log2(last[k] / errors[k]), 3.5) << along;
    last = errors;
  }
  EXPECT_LT(last[0], 5e-7);
}

TEST(SectionModes, OfCircles) {
  expect_antisymmetric(test::circle(0.25), 0.125, {4.511981, 19.191909, 34.108367});
  expect_antisymmetric(test::circle(0.25), 0.25, {5.422908, 18.604218, 31.279455});
  expect_antisymmetric(test::circle(0.25), 0.375, {7.595524, 22.513525, 37.088012});
  // 10, 60 and 90 % full, by omega^2 R/g.
  EXPECT_NEAR(eigenvalues(test::circle(1), 0.2, 1)[0] / 1.04385, 1, 1e-4);
  EXPECT_NEAR(eigenvalues(test::circle(1), 1.2, 1)[0] / 1.50751, 1, 1e-4);
  EXPECT_NEAR(eigenvalues(test::circle(1), 1.8, 1)[0] / 3.02140, 1, 1e-4);
}

TEST(SectionModes, OfACircleThatAreSymmetric) {
  const auto all = eigenvalues(test::circle(0.25), 0.25, 6);
  EXPECT_NEAR(all[1] / 12.132419, 1, 1e-4);
  EXPECT_NEAR(all[3] / 24.956791, 1, 1e-4);
  EXPECT_NEAR(all[5] / 37.586730, 1, 1e-4);
}

TEST(SectionModes, OfAChamferedTank) {
  const Polygons section{{{0.1, 0}, {0.5, 0}, {0.6, 0.1}, {0.6, 0.4}, {0, 0.4}, {0, 0.1}}};
  expect_antisymmetric(section, 0.1, {2.398860, 12.346459, 23.263873});
  expect_antisymmetric(section, 0.2, {4.038172, 15.569114, 26.165316});
  expect_antisymmetric(section, 0.3, {4.782028, 15.701921, 26.179861});
}

TEST(SectionModes, OfAHexagon) {
  const double middle = 0.125 * std::sqrt(3);
  const Polygons section{
      {{-0.125, 0}, {0.125, 0}, {0.25, middle}, {0.125, 2 * middle}, {-0.125, 2 * middle}, {-0.25, middle}}};
  expect_antisymmetric(section, 0.10825, {5.655563, 22.808941, 39.769121});
  expect_antisymmetric(section, middle, {4.811805, 17.256586, 29.846402});
}

TEST(SectionModes, OfABoxWithABaffle) {
  // The references' own change from mesh to mesh goes up to 4e-4 here.
  expect_antisymmetric(test::baffled(0.02), 0.2, {4.407906, 18.692018, 31.403800});
  expect_antisymmetric(test::baffled(0.01), 0.2, {4.491344, 18.704864, 31.405034});
  expect_antisymmetric(test::baffled(0.0001), 0.2, {4.601709, 18.724785, 31.406956});
}

TEST(SectionModes, OfAPlateWithoutThicknessAreTheLimitOfThinOnes) {
  const double plate = eigenvalues(test::baffled(0), 0.2, 1)[0];
  const double thin = eigenvalues(test::baffled(1e-6), 0.2, 1)[0];
  EXPECT_NEAR(plate / 4.602, 1, 1e-3);
  EXPECT_NEAR(thin / plate, 1, 1e-4);
}

TEST(SectionModes, OfAPlateInMidWaterLeaveTheFirstModeOfItsPlaneAlone) {
  // Nothing moves sideways in the plane of symmetry of the second mode, so the plate does nothing there.
  Polygons section = test::box(0.5, 0.3);
  section.push_back({{0.25, 0.05}, {0.25, 0.15}});
  const auto all = eigenvalues(section, 0.2, 2);
  const auto box = box_frequencies({0.5}, 0.2, g, 2);
  EXPECT_LT(all[0], 0.97 * box[0] * box[0] / g);
  EXPECT_NEAR(all[1] / (box[1] * box[1] / g), 1, 3e-5);
}

TEST(SectionModes, OfASphere) {
  const auto all = eigenvalues(test::half_circle(0.25), 0.25, 3, {true, 1, 0});
  const std::vector<double> expected{6.240629, 21.102184, 34.017765};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(all[k] / expected[k], 1, 1e-4);
}

TEST(SectionModes, OfAnUprightCylinder) {
  for (int m = 0; m < 4; ++m) {
    const auto all = eigenvalues(test::box(0.25, 0.4), 0.2, 3, {true, m, 0});
    const auto zeros = bessel_slope_zeros(m, 3);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(all[k] / (zeros[k] / 0.25 * std::tanh(zeros[k] / 0.25 * 0.2)), 1, 1e-4) << m;
  }
}

TEST(SectionModes, OfARingTank) {
  // Between two cylinders: J_1'(k a) Y_1'(k b) = J_1'(k b) Y_1'(k a).
  const double a = 0.1, b = 0.2, h = 0.5;
  const auto slope = [](auto f, double x) { return 0.5 * (f(0.0, x) - f(2.0, x)); };
  const auto j = [](double m, double x) { return std::cyl_bessel_j(m, x); };
  const auto y = [](double m, double x) { return std::cyl_neumann(m, x); };
  const auto residual = [&](double k) { return slope(j, k * a) * slope(y, k * b) - slope(j, k * b) * slope(y, k * a); };
  const Polygons section{{{a, 0}, {b, 0}, {b, 1}, {a, 1}}};
  const double k = eigenvalues(section, h, 3, {true, 1, 0})[0] / std::tanh(h * 1.3547 / b);
  EXPECT_NEAR(k * b, 1.3547, 1e-3);
  EXPECT_LT(residual(k * (1 - 5e-5)) * residual(k * (1 + 5e-5)), 0);
}

TEST(SectionModes, AlongABox) {
  // Waves across and along: k^2 = (n pi / L)^2 + q^2.
  const double q = pi / 0.8;
  const auto all = eigenvalues(test::box(0.5, 0.3), 0.2, 3, {false, 0, q});
  for (std::size_t n = 0; n < 3; ++n) {
    const double k = std::hypot(static_cast<double>(n) * pi / 0.5, q);
    EXPECT_NEAR(all[n] / (k * std::tanh(k * 0.2)), 1, 5e-5);
  }
}

TEST(SectionModes, AlongABoxWithShortWaves) {
  const double q = 20 * pi / 0.5;
  EXPECT_NEAR(eigenvalues(test::box(0.5, 0.3), 0.2, 1, {false, 0, q})[0] / q, 1, 1e-4);
}

TEST(SectionModes, AlongALyingCylinder) {
  EXPECT_NEAR(eigenvalues(test::circle(1), 1, 1, {false, 0, pi / 4})[0] / 0.42570, 1, 1e-4);
}

TEST(SectionModes, OfAUTubeAreThoseOfItsLengthOfLiquid) {
  // Two wide shafts joined by a pipe below: a column of liquid, omega^2 = 2 g / sum of (length b / breadth) of legs b
  // broad.
  const double b = 0.01, l = 1, h = 0.4;
  const Polygons section{{{0, 0}, {l, 0}, {l, 1}, {l - b, 1}, {l - b, b}, {b, b}, {b, 1}, {0, 1}}};
  EXPECT_NEAR(eigenvalues(section, h, 1)[0], 2 / (2 * h + l - 2 * b), 0.01 * 2 / (2 * h + l));
}

TEST(SectionModes, OfTwoChambersAreThoseOfEach) {
  const Polygons section{{{0, 0}, {0.3, 0}, {0.3, 0.25}, {0.31, 0.25}, {0.31, 0.1}, {0.5, 0.1}, {0.5, 0.3}, {0, 0.3}}};
  const auto chambers = section_modes(section, 0.2, g, 2);
  ASSERT_EQ(chambers.size(), 2u);
  for (const Chamber& chamber : chambers) {
    const bool first = chamber.across.front() < 0.1;
    const auto exact = first ? box_frequencies({0.3}, 0.2, g, 2) : box_frequencies({0.19}, 0.1, g, 2);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(chamber.modes[k].frequency / exact[k], 1, 5e-5);
  }
}

TEST(SectionModes, ElevationOfABoxIsACosine) {
  const Chamber chamber = section_modes(test::box(0.5, 0.3), 0.2, g, 3)[0];
  for (std::size_t n = 0; n < 3; ++n) {
    const double sign = chamber.modes[n].elevation[0];
    for (std::size_t k = 0; k < chamber.across.size(); ++k)
      EXPECT_NEAR(sign * chamber.modes[n].elevation[k],
                  std::cos((static_cast<double>(n) + 1) * pi * chamber.across[k] / 0.5), 1e-3);
  }
}

TEST(SectionModes, ElevationKeepsTheVolume) {
  const Chamber chamber = section_modes(test::circle(0.25), 0.3, g, 4)[0];
  for (const Mode& mode : chamber.modes) {
    double volume = 0;
    // Simpson's rule: corners and middles of edges take turns.
    for (std::size_t k = 0; k + 2 < chamber.across.size(); k += 2)
      volume += (chamber.across[k + 2] - chamber.across[k]) / 6 *
                (mode.elevation[k] + 4 * mode.elevation[k + 1] + mode.elevation[k + 2]);
    EXPECT_NEAR(volume, 0, 1e-9);
  }
}

TEST(SectionModes, GoWithTheSquareRootOfGravityOverSize) {
  Polygons section = test::baffled(0.02);
  const double small = section_modes(section, 0.2, g, 1)[0].modes[0].frequency;
  for (Vec<2>& at : section[0]) at = 100 * at + Vec<2>(1000, -500);
  const double large = section_modes(section, 20 - 500, g / 4, 1)[0].modes[0].frequency;
  EXPECT_NEAR(large / small, 1.0 / 20, 1e-6);
}

TEST(SectionModes, RefuseGravityAndRadiusThatFitNothing) {
  EXPECT_THROW(section_modes(test::box(1, 1), 0.5, 0, 1), BadParameters);
  EXPECT_THROW(section_modes(test::circle(1), 0.5, g, 1, {true, 1, 0}), BadParameters);
}

}  // namespace
}  // namespace seiche::solver::modes
