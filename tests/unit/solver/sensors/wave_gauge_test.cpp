#include "solver/sensors/wave_gauge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

const std::vector<double> places{0, 0.001, 0.005, 0.0123, 0.05, 0.1, 0.1025, 0.109, 0.1777, 0.1999, 0.2};

template <class T, int D = T::D>
struct WaveGaugeOf : ::testing::Test {
  SensedTank<D> tank;

  /// Of a gauge at x, midway across.
  double level(double x) const {
    SurfaceProfile<D> surface = tank.profile();
    surface.find(tank.s, tank.cells());
    return WaveGauge(x, 0.06, 0.1, *tank.shape, surface.lattice()).level(surface);
  }
};
TYPED_TEST_SUITE(WaveGaugeOf, test::Dimensions);

TYPED_TEST(WaveGaugeOf, ReadsTheDepthOfALatticeAtRestAnywhere) {
  for (double x : places) EXPECT_NEAR(this->level(x), 0.1, 1e-13) << "x = " << x;
}

TYPED_TEST(WaveGaugeOf, FollowsARiseFinerThanTheSpacing) {
  constexpr int D = TypeParam::D;
  for (int tenths = 1; tenths <= 10; ++tenths) {
    this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += 0.1 * l0; });
    for (double x : places)
      EXPECT_NEAR(this->level(x), 0.1 + 0.1 * tenths * l0, 0.05 * l0) << "x = " << x << ", " << tenths;
  }
}

TYPED_TEST(WaveGaugeOf, ReadsASlopeAtItsOwnPlace) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += 0.2 * (r[0] - 0.1); });
  for (double x : {0.07, 0.1, 0.1025, 0.13})
    EXPECT_NEAR(this->level(x), 0.1 + 0.2 * (x - 0.1), 0.05 * l0) << "x = " << x;
  // At the walls the mirror bends the surface: it reads 0.7 l0 of its slope towards the middle.
  for (double x : {0., 0.2}) EXPECT_NEAR(this->level(x), 0.1 + 0.2 * (x - 0.1), 0.2 * 0.75 * l0) << "x = " << x;
}

// Standing waves of length 20 l0: crest or trough at the walls and half-way.
TYPED_TEST(WaveGaugeOf, KeepsAWaveOfTwentySpacings) {
  constexpr int D = TypeParam::D;
  const double a = l0;
  this->tank.each_fluid([&](Vec<D>& r, double&) { r[1] += a * std::cos(2 * std::numbers::pi * r[0] / 0.2); });
  for (double x : {0., 0.05, 0.1, 0.15, 0.2})
    EXPECT_NEAR(this->level(x), 0.1 + a * std::cos(2 * std::numbers::pi * x / 0.2), 0.05 * l0) << "x = " << x;
}

// Particles that scatter each for itself: what the averaging gains, two of the three gauges being at a wall.
TYPED_TEST(WaveGaugeOf, ScattersLessThanItsColumns) {
  constexpr int D = TypeParam::D;
  std::mt19937_64 random(3);
  double gauges = 0, columns = 0;
  for (int k = 0; k < 10; ++k) {
    this->tank = SensedTank<D>();
    this->tank.each_fluid([&](Vec<D>& r, double&) { r += 0.25 * l0 * test::random_vec<D>(random, -1, 1); });
    SurfaceProfile<D> surface = this->tank.profile();
    surface.find(this->tank.s, this->tank.cells());
    for (double x : {0., 0.1, 0.2}) gauges += std::pow(this->level(x) - 0.1, 2) / 30;
    for (int c = 0; c < 20; ++c) columns += std::pow(surface.height(c) - 0.1, 2) / 200;
  }
  EXPECT_LT(gauges, 0.8 * columns) << std::sqrt(gauges) / l0 << " of " << std::sqrt(columns) / l0;
}

TYPED_TEST(WaveGaugeOf, NeverLeavesWhatItsColumnsShow) {
  constexpr int D = TypeParam::D;
  // Water in the left half alone: beyond the step nothing rings.
  this->tank.each_fluid([](Vec<D>& r, double&) { r[0] = std::min(r[0], 0.105); });
  for (double x : places) {
    EXPECT_GE(this->level(x), 0) << "x = " << x;
    if (x >= 0.19) {
      EXPECT_EQ(this->level(x), 0) << "x = " << x;
    }
  }
}

TEST(GaugeWeights, HaveTheMomentsOfASmoothFit) {
  for (double x : {20., 20.25, 20.5, 20.9}) {
    const Scalars weights = gauge_weights(x, 40);
    double moment[4] = {};
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 4; ++k) moment[k] += weights[i] * std::pow(i + 0.5 - x, k);
    EXPECT_NEAR(moment[0], 1, 1e-12);
    EXPECT_NEAR(moment[1], 0, 1e-12);
    EXPECT_NEAR(moment[2], -1. / 3, 1e-12);
    EXPECT_NEAR(moment[3], 0, 0.03);
  }
}

TEST(GaugeWeights, DampAWaveOfTwentySpacingsByLessThanTwoPerCent) {
  for (double x : {20., 20.3, 0., 0.7}) {
    const Scalars weights = gauge_weights(x, 40);
    const double k = 2 * std::numbers::pi / 20;
    double sum = 0;
    for (int i = 0; i < 40; ++i) sum += weights[i] * std::cos(k * (i + 0.5));
    // The fluid fraction itself smooths by the transform of KF4.
    const double sinc = std::sin(0.5 * k) / (0.5 * k);
    EXPECT_NEAR(sum * std::pow(sinc, 4), std::cos(k * x), 0.015) << x;
  }
}

TEST(GaugeWeights, AddUpToOneInARowShorterThanTheirReach) {
  for (double x : {0., 1.7, 4.}) {
    double sum = 0;
    for (double weight : gauge_weights(x, 4)) sum += weight;
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

}  // namespace
}  // namespace seiche::solver
