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

Jet Record::at(double t) const {
  const double time = t + from;
  if (held && time < spline.first()) return {spline.at(spline.first()).value, 0, 0};
  if (held && time > spline.last()) return {spline.at(spline.last()).value, 0, 0};
  return spline.at(time);
}

void Course::add(double amplitude, double frequency, double phase) {
  terms_.push_back({amplitude, 2 * std::numbers::pi * frequency, phase});
}

Jet Course::at(double t) const {
  Jet sum;
  if (record_) sum = record_->at(t);
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

double Course::greatest_of(double Jet::*of, int derivative) const {
  double sum = 0;
  if (record_) {
    const Spline& spline = record_->spline;
    const int points = 10 * static_cast<int>(spline.size() - 1);
    for (int k = 0; k <= points; ++k) {
      const double t = spline.first() + (spline.last() - spline.first()) * k / points;
      sum = std::max(sum, std::abs(spline.at(t).*of));
    }
  }
  for (const Term& term : terms_) sum += std::abs(term.amplitude) * std::pow(term.omega, derivative);
  return sum;
}

double Course::greatest() const { return greatest_of(&Jet::value, 0); }

double Course::fastest() const {
  const double sum = greatest_of(&Jet::rate, 1);
  // The rate of the ramp itself is 15/8 over its time at most.
  return ramp_ > 0 ? sum + 1.875 / ramp_ * greatest() : sum;
}

double Course::greatest_acceleration() const {
  const double sum = greatest_of(&Jet::acceleration, 2);
  if (ramp_ <= 0) return sum;
  // The ramp's second derivative is 10/sqrt(3) over the square of its time at most.
  return sum + 2 * 1.875 / ramp_ * greatest_of(&Jet::rate, 1) + 10 / std::sqrt(3) / (ramp_ * ramp_) * greatest();
}

}  // namespace seiche::solver
