#include "apps/validate/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "apps/common/filter.hpp"
#include "apps/validate/fit.hpp"
#include "apps/validate/surface.hpp"

namespace seiche::apps::validate {
namespace {

using std::numbers::pi;

// A growing oscillation about 0.2 with a gap from 2 to 2.6 s, and another one, late, low and rough, beside it.
Series reference() {
  Series s;
  for (int i = 0; i <= 350; ++i) {
    const double t = 0.02 * i;
    if (t > 2.0 && t < 2.59) continue;
    s.t.push_back(t);
    s.y.push_back(std::sin(2 * pi * t) * std::exp(0.1 * t) + 0.2);
  }
  return s;
}

Series rough() {
  Series s;
  for (int i = 0; i <= 6500; ++i) {
    const double t = 0.001 * i;
    s.t.push_back(t);
    s.y.push_back(0.95 * std::sin(2 * pi * (t - 0.01)) * std::exp(0.1 * t) + 0.23 + 0.03 * std::sin(2 * pi * 40 * t));
  }
  return s;
}

Series sine(double frequency) {
  Series s;
  for (int i = 0; i <= 5000; ++i) {
    s.t.push_back(0.001 * i);
    s.y.push_back(100 + std::sin(2 * pi * frequency * s.t.back()));
  }
  return s;
}

// The numbers are those of the independent program that these measures were first defined by.
TEST(Measures, AgreeWithAnIndependentProgram) {
  const Difference d = compare(reference(), rough(), {0.5, 6, 0.2});
  EXPECT_EQ(d.count, 491u) << "times in the gap don't count";
  EXPECT_NEAR(d.rms, 0.08926061081344447, 1e-12);
  EXPECT_NEAR(d.bias, 0.036959112924959105, 1e-12);
  EXPECT_NEAR(d.most, 0.1941840945249278, 1e-12);
  EXPECT_NEAR(d.ref_most, 1.7753982766393548, 1e-12);
  EXPECT_NEAR(d.of_most(), 0.050276386987603464, 1e-12);
  EXPECT_NEAR(d.of_deviation(), 0.08863567971886724, 1e-12);

  EXPECT_NEAR(noise(rough(), 0.5, 6, 10), 0.02113078331898566, 1e-10);
  const Series low = low_pass(rough(), 0.5, 6, 10);
  ASSERT_EQ(low.size(), 5501u);
  EXPECT_NEAR(low.y[0], 0.29270936626167354, 1e-10);
  EXPECT_NEAR(low.y[1000], 0.2992906561759201, 1e-10);
  EXPECT_NEAR(low.y[5500], 0.12130879236600568, 1e-10);
}

TEST(Measures, OfASeriesWithItselfAndOneBesideIt) {
  const Series s = sine(1);
  const Difference same = compare(s, s, {0, 5, 100});
  EXPECT_EQ(same.rms, 0);
  EXPECT_NEAR(same.ref_rms, std::sqrt(0.5), 1e-3);
  Series higher = s;
  for (double& y : higher.y) y += 0.25;
  const Difference beside = compare(s, higher, {0, 5, 100});
  EXPECT_NEAR(beside.bias, 0.25, 1e-12);
  EXPECT_NEAR(beside.of_most(), 0.25, 1e-3);
  EXPECT_NEAR(beside.unbiased_of_most(), 0, 1e-6);
  EXPECT_NEAR(beside.relative_l2(), 0.25 * std::sqrt(2), 1e-3);
  EXPECT_THROW(compare(s, s, {5.5, 6}), std::runtime_error);
}

TEST(Filter, PassesWhatLiesAboveTheCutAndStopsTheRest) {
  for (const double frequency : {1.0, 5.0, 10.0, 20.0, 100.0}) {
    const double ratio = std::tan(pi * 10 / 1000) / std::tan(pi * frequency / 1000);
    const double gain = 1 / (1 + std::pow(ratio, 4));
    EXPECT_NEAR(noise(sine(frequency), 0, 5, 10), gain * std::sqrt(0.5), 0.01 * std::sqrt(0.5)) << frequency << " Hz";
  }
  const Series slow = low_pass(sine(1), 0, 5, 10);
  for (std::size_t i = 0; i < slow.size(); i += 100) EXPECT_NEAR(slow.y[i], sine(1).y[i], 1e-3);
}

TEST(Filter, RefusesTooFewSamples) {
  EXPECT_THROW(noise(sine(1), 0, 0.04, 10), std::runtime_error);
  EXPECT_THROW(noise(sine(1), 0, 5, 300), std::runtime_error);
}

TEST(Profiles, AreComparedByHeightAwayFromTheWalls) {
  const Series theory{{0, 0.1, 0.3, 0.6}, {0.2, 0.21, 0.19, 0.2}};
  const Series run{{0.005, 0.05, 0.2, 0.45, 0.595}, {0.5, 0.206, 0.201, 0.19, 0.5}};
  const ProfileDistance d = profile_distance(theory, run, 0.01, 0.59);
  EXPECT_EQ(d.count, 3);
  EXPECT_NEAR(d.squares, 0.001 * 0.001 + 0.001 * 0.001 + 0.005 * 0.005, 1e-15);
}

TEST(Fit, FindsTheOrder) {
  EXPECT_NEAR(order({0.01, 0.005, 0.0025}, {0.03, 0.03 / std::pow(2, 1.5), 0.03 / std::pow(4, 1.5)}), 1.5, 1e-12);
}

TEST(Fit, FindsADampedOscillation) {
  Series s;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    s.t.push_back(t);
    s.y.push_back(0.9 * std::exp(-0.3 * t) * std::cos(6.4 * t + 0.2));
  }
  const Oscillation found = fit_oscillation(s, 6.3);
  EXPECT_NEAR(found.amplitude, 0.9, 1e-9);
  EXPECT_NEAR(found.decay, 0.3, 1e-9);
  EXPECT_NEAR(found.omega, 6.4, 1e-9);
  EXPECT_NEAR(found.phase, 0.2, 1e-9);
  EXPECT_NEAR(found.at(1), s.y[100], 1e-9);
}

}  // namespace
}  // namespace seiche::apps::validate
