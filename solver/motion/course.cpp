#include "solver/motion/course.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {

Jet smooth_step(double t, double time) {
  if (t <= 0) return {0, 0, 0};
  if (t >= time) return {1, 0, 0};
  const double s = t / time, r = 1 - s;
  return {s * s * s * (10 - 15 * s + 6 * s * s), 30 * s * s * r * r / time, 60 * s * r * (1 - 2 * s) / (time * time)};
}

void Course::add(double amplitude, double frequency, double phase) {
  terms_.push_back({amplitude, 2 * std::numbers::pi * frequency, phase});
}

Jet Course::at(double t) const {
  Jet sum;
  if (spline_) sum = spline_->at(t);
  for (const Term& term : terms_) {
    const double angle = term.omega * t + term.phase, value = term.amplitude * std::sin(angle);
    sum.value += value;
    sum.rate += term.amplitude * term.omega * std::cos(angle);
    sum.acceleration -= term.omega * term.omega * value;
  }
  if (ramp_ <= 0 || t >= ramp_) return sum;
  const Jet step = smooth_step(t, ramp_);
  return {step.value * sum.value, step.value * sum.rate + step.rate * sum.value,
          step.value * sum.acceleration + 2 * step.rate * sum.rate + step.acceleration * sum.value};
}

template <class Of>
double Course::greatest_of_spline(Of of) const {
  if (!spline_) return 0;
  const int points = 10 * static_cast<int>(spline_->size() - 1);
  double greatest = 0;
  for (int k = 0; k <= points; ++k) {
    const double t = spline_->first() + (spline_->last() - spline_->first()) * k / points;
    greatest = std::max(greatest, std::abs(of(spline_->at(t))));
  }
  return greatest;
}

double Course::greatest() const {
  double sum = greatest_of_spline([](const Jet& jet) { return jet.value; });
  for (const Term& term : terms_) sum += std::abs(term.amplitude);
  return sum;
}

double Course::fastest() const {
  double sum = greatest_of_spline([](const Jet& jet) { return jet.rate; });
  for (const Term& term : terms_) sum += std::abs(term.amplitude * term.omega);
  // The rate of the ramp itself is 15/8 over its time at most.
  return ramp_ > 0 ? sum + 1.875 / ramp_ * greatest() : sum;
}

}  // namespace seiche::solver
