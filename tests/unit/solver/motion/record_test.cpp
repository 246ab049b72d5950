#include "solver/motion/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/motion/spline.hpp"

namespace seiche::solver {
namespace {

std::vector<double> sampled(const std::vector<double>& time, double (*f)(double)) {
  std::vector<double> values;
  for (const double t : time) values.push_back(f(t));
  return values;
}

/// From 0 to `end`; `uneven` shifts every second sample by that share of an interval.
std::vector<double> times(double end, int intervals, double uneven = 0) {
  std::vector<double> all;
  for (int k = 0; k <= intervals; ++k)
    all.push_back(end / intervals * (k + (k % 2 == 1 && k < intervals ? uneven : 0)));
  return all;
}

double wave(double t) { return std::sin(2 * std::numbers::pi * t); }
double wave_acceleration(double t) { return -4 * std::numbers::pi * std::numbers::pi * wave(t); }

TEST(Unwrapped, AnglesHaveNoJumpsOfWholeTurns) {
  EXPECT_EQ(unwrapped({170, 179, -179, -170, 179, 10}), (std::vector<double>{170, 179, 181, 190, 179, 10}));
  EXPECT_EQ(unwrapped({0, 340, 320, 359, 1}), (std::vector<double>{0, -20, -40, -1, 1}));
  EXPECT_EQ(unwrapped({0, 100, -50}), (std::vector<double>{0, 100, -50})) << "half a turn may be meant";
  EXPECT_TRUE(unwrapped({}).empty());
}

TEST(IntegratedTwice, IsExactForACubicAndTakesItsParabolaOut) {
  const auto t = times(2, 20, 0.3);
  const auto cubic = sampled(t, [](double s) { return 7 - 2 * s + 3 * s * s - 5 * s * s * s; });
  // The same displacement but for the parabola: it comes out as if that weren't there.
  const auto less = sampled(t, [](double s) { return -2 * s + 3 * s * s - 5 * s * s * s; });
  const auto with = integrated_twice(t, cubic), without = integrated_twice(t, less);
  const auto exact = sampled(t, [](double s) { return std::pow(s, 4) / 4 - std::pow(s, 5) / 4 - s * s * s / 3; });
  std::vector<double> rest;
  for (std::size_t k = 0; k < t.size(); ++k) {
    EXPECT_NEAR(with[k], without[k], 1e-13);
    rest.push_back(with[k] - exact[k]);
  }
  // What differs from the exact integral is a parabola: its third differences over even intervals are 0.
  for (std::size_t k = 0; k + 6 < t.size(); k += 2)
    EXPECT_NEAR(rest[k + 6] - 3 * rest[k + 4] + 3 * rest[k + 2] - rest[k], 0, 1e-12);
}

TEST(IntegratedTwice, FindsAWaveWhateverTheGaugesConstantError) {
  const auto t = times(20, 2000);
  auto record = sampled(t, wave_acceleration);
  for (double& value : record) value += 0.3;
  const auto found = integrated_twice(t, record);
  double worst = 0;
  for (std::size_t k = 0; k < t.size(); ++k) worst = std::max(worst, std::abs(found[k] - wave(t[k])));
  // The parabola nearest to a sine over n periods has 3/(pi n) of its height at the ends.
  EXPECT_LT(worst, 1.1 * 3 / (20 * std::numbers::pi));
  EXPECT_GT(worst, 0.5 * 3 / (20 * std::numbers::pi)) << "the bound is near";
}

TEST(Smoothed, LeavesAStraightLineAsItIsAlsoBetweenUnevenTimes) {
  const auto t = times(1, 50, 0.4);
  const auto line = sampled(t, [](double s) { return 2 - 3 * s; });
  const auto found = smoothed(t, line, 5);
  for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(found[k], line[k], 1e-11);
}

TEST(Smoothed, KeepsOfAWaveWhatItSaysAndAllOfItsPhase) {
  const auto t = times(40, 8000, 0.3);
  const auto record = sampled(t, wave);
  for (const double cutoff : {0.5, 1.0, 2.0, 5.0}) {
    const auto found = smoothed(t, record, cutoff);
    const double gain = 1 / (1 + std::pow(1 / cutoff, 4));
    for (std::size_t k = 2000; k < 6000; ++k) EXPECT_NEAR(found[k], gain * record[k], 2e-3 * gain) << cutoff;
  }
}

TEST(Resolution, IsWhatTheValuesAreMultiplesOf) {
  EXPECT_NEAR(resolution({0, 0.3, 0.2, 0.9, -0.1}), 0.1, 1e-12);
  EXPECT_NEAR(resolution({0.05, 0.30, 1.05}), 0.25, 1e-12) << "no power of ten";
  EXPECT_EQ(resolution({2, 2, 2}), 0);
  std::vector<double> exact;
  for (int k = 0; k < 100; ++k) exact.push_back(std::sin(0.1 * k));
  EXPECT_LT(resolution(exact), 1e-4);
}

/// The RMS acceleration of the spline through a record, less that of the exact wave.
double rms_error(const std::vector<double>& time, const std::vector<double>& values, double height) {
  const Spline spline(time, values);
  double sum = 0;
  for (std::size_t k = 20; k + 20 < time.size(); ++k)
    sum += std::pow(spline.at(time[k]).acceleration - height * wave_acceleration(time[k]), 2);
  return std::sqrt(sum / static_cast<double>(time.size() - 40));
}

TEST(RoundingAcceleration, IsThatOfARoundedRecord) {
  const auto t = times(10, 2000);
  auto record = sampled(t, wave);
  for (double& value : record) value = 0.02 * std::round(value / 0.02);
  EXPECT_NEAR(rounding_acceleration(t, record, 0) / rms_error(t, record, 1), 1, 0.15);
  for (const double cutoff : {5.0, 10.0})
    EXPECT_NEAR(rounding_acceleration(t, record, cutoff) / rms_error(t, smoothed(t, record, cutoff), 1), 1, 0.5);
}

TEST(RoundingAcceleration, IsThatOfRoundedTimes) {
  const auto exact = times(10, 2718);  // whose rounding errors follow no pattern
  const auto record = sampled(exact, wave);
  std::vector<double> rounded;
  for (const double t : exact) rounded.push_back(1e-3 * std::round(1e3 * t));
  EXPECT_NEAR(rounding_acceleration(rounded, record, 0) / rms_error(rounded, record, 1), 1, 0.3);
  EXPECT_LT(rounding_acceleration(exact, record, 0), 2) << "of 28 RMS: intervals that are equal are exact";
}

}  // namespace
}  // namespace seiche::solver
