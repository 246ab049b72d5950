#include "solver/motion/course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

/// Expects rate and acceleration at t to be the slopes of value and rate.
template <class Of>
void expect_consistent(const Of& of, double t, double tolerance) {
  constexpr double h = 1e-5;
  const Jet before = of(t - h), now = of(t), after = of(t + h);
  EXPECT_NEAR((after.value - before.value) / (2 * h), now.rate, tolerance) << t;
  EXPECT_NEAR((after.rate - before.rate) / (2 * h), now.acceleration, tolerance) << t;
}

TEST(SmoothStep, GrowsFromNothingToOneWithoutAJumpInItsAcceleration) {
  const auto step = [](double t) { return smooth_step(t, 2); };
  for (double t : {-0.5, 0.0, 0.3, 1.0, 1.7, 2.0, 2.5}) expect_consistent(step, t, 1e-4);
  EXPECT_EQ(step(0).value, 0);
  EXPECT_EQ(step(1).value, 0.5);
  EXPECT_EQ(step(2).value, 1);
  EXPECT_EQ(step(1).rate, 1.875 / 2) << "its greatest";
  for (double end : {1e-9, 2 - 1e-9}) {
    EXPECT_NEAR(step(end).rate, 0, 1e-8);
    EXPECT_NEAR(step(end).acceleration, 0, 1e-7);
  }
}

TEST(Course, HasTheDerivativesOfItsValueAlsoWhileItGrows) {
  for (double ramp : {0.0, 1.5}) {
    Course course(ramp);
    course.add(0.3, 0.8, 0.4);
    course.add(-0.1, 2.3, 0);
    for (double t = 0.05; t < 3; t += 0.19) expect_consistent([&](double at) { return course.at(at); }, t, 3e-7);
  }
}

TEST(Course, OfARampIsAtRestAtFirstAndItselfAfterwards) {
  Course grown(0), growing(1.5);
  for (Course* course : {&grown, &growing}) course->add(0.3, 0.8, 0.4);
  EXPECT_EQ(growing.at(0).value, 0);
  EXPECT_EQ(growing.at(0).rate, 0);
  EXPECT_EQ(growing.at(0).acceleration, 0);
  EXPECT_EQ(growing.at(1.5).rate, grown.at(1.5).rate);
  EXPECT_LT(growing.at(0.3).value, grown.at(0.3).value);
}

TEST(Course, IsNeverGreaterNorFasterNorHarderAcceleratedThanItSays) {
  Course course(0.2);
  course.add(0.3, 0.8, 0.4);
  course.add(-0.1, 2.3, 0);
  std::vector<double> t, y;
  for (int k = 0; k <= 40; ++k) t.push_back(0.1 * k), y.push_back(0.2 * std::sin(2 * t.back()));
  course.follow({Spline(t, y)});
  double greatest = 0, fastest = 0, acceleration = 0;
  for (double at = 0; at < 4; at += 0.001) {
    greatest = std::max(greatest, std::abs(course.at(at).value));
    fastest = std::max(fastest, std::abs(course.at(at).rate));
    acceleration = std::max(acceleration, std::abs(course.at(at).acceleration));
  }
  EXPECT_LE(greatest, course.greatest());
  EXPECT_LE(fastest, course.fastest());
  EXPECT_LE(acceleration, course.greatest_acceleration());
  EXPECT_NEAR(course.greatest(), 0.6, 1e-4);
  EXPECT_TRUE(course.moves());
  EXPECT_FALSE(Course(1).moves());
}

TEST(Course, ItsGreatestAccelerationIsReached) {
  Course course(0);
  course.add(0.3, 0.8, 0.4);
  EXPECT_NEAR(course.greatest_acceleration(), 0.3 * std::pow(1.6 * std::numbers::pi, 2), 1e-12);
  // Of a slow term under a short ramp it is the ramp's, 10/sqrt(3)/T^2 of the amplitude.
  Course ramped(0.1);
  ramped.add(0.3, 1e-6, std::numbers::pi / 2);
  double greatest = 0;
  for (double at = 0; at < 0.1; at += 1e-5) greatest = std::max(greatest, std::abs(ramped.at(at).acceleration));
  EXPECT_LE(greatest, ramped.greatest_acceleration());
  EXPECT_NEAR(ramped.greatest_acceleration() / greatest, 1, 1e-3);
}

}  // namespace
}  // namespace seiche::solver
