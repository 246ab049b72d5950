#include "solver/motion/warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver::test {
namespace {

bool warns(const Parameters& p, const char* of) {
  for (const std::string& warning : warnings(p))
    if (warning.find(of) != std::string::npos) return true;
  return false;
}

/// Surge of 10 mm at 1 Hz as a file has it, rounded to whole steps.
Parameters recorded(double step) {
  Parameters p = small_tank<2>();
  p.motion = {.type = MotionType::file, .file = "record"};
  for (int k = 0; k <= 200; ++k) {
    const double t = 0.01 * k, value = 0.01 * std::sin(2 * std::numbers::pi * t);
    p.motion.series.time.push_back(t);
    p.motion.series[DegreeOfFreedom::surge].push_back(std::round(value / step) * step);
  }
  p.time.end = 2;
  return p;
}

TEST(Warnings, AreNoneOfATankAtRest) { EXPECT_TRUE(warnings(small_tank<2>()).empty()); }

TEST(Warnings, TellOfATankThatSurelyIsInAnotherUnit) {
  Parameters p = small_tank<2>();
  p.tank.length = 600;
  EXPECT_TRUE(warns(p, "600 m long"));
}

TEST(Warnings, TellOfMoreThanTwiceGravity) {
  Parameters p = small_tank<2>();
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.01, 7}};
  EXPECT_FALSE(warns(p, "acceleration"));  // 19.3 m/s^2
  p.motion.harmonic.frequency = 7.2;       // 20.5
  EXPECT_TRUE(warns(p, "acceleration"));
}

// The second difference of values rounded to steps d has an RMS of d sqrt(6/12)/dt^2: 0.7 m/s^2 of 0.1 mm, where the
// motion itself has 0.28; 0.007 of 1 um.
TEST(Warnings, TellOfARecordThatIsMostlyRounding) {
  EXPECT_TRUE(warns(recorded(1e-4), "rounding"));
  EXPECT_FALSE(warns(recorded(1e-6), "rounding"));
}

TEST(Warnings, OfRoundingEndWhereTheRecordIsSmoothed) {
  Parameters p = recorded(1e-4);
  p.motion.cutoff = 4;
  EXPECT_FALSE(warns(p, "rounding"));
}

TEST(Warnings, TellOfATankThatStartsTiltedUnlessItsLiquidStartsLevel) {
  Parameters p = small_tank<2>();
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 4, 0.5, 90}};
  EXPECT_TRUE(warns(p, "tilted by 4 degrees"));
  p.motion.start = Start::level;
  EXPECT_FALSE(warns(p, "tilted"));
}

TEST(Warnings, TellOfASpeedThatEndsWhereARecordIsHeld) {
  Parameters p = recorded(1e-9);
  p.motion.hold = true;
  p.time.end = 3;  // the record ends at 2 s, at its greatest speed
  EXPECT_TRUE(warns(p, "jumps by 0.0628 m/s at 2 s"));
}

TEST(GreatestAcceleration, IsThatOfTheFarthestCorner) {
  Parameters p = small_tank<2>();
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 1, 1, 90}};
  p.time.end = 1;
  const double alpha = std::numbers::pi / 180 * std::pow(2 * std::numbers::pi, 2);
  EXPECT_NEAR(greatest_acceleration(p).value, alpha * std::hypot(0.2, 0.15), 1e-6);
}

}  // namespace
}  // namespace seiche::solver::test
