#pragma once
#include <optional>
#include <vector>

#include "solver/motion/spline.hpp"

namespace seiche::solver {

/// How one degree of freedom moves: ramp(t) (sum of A sin(2 pi f t + phase) + spline(t)).
class Course {
 public:
  /// @param ramp time over which the motion grows from nothing [s]; 0: it is there from the start
  explicit Course(double ramp) : ramp_(ramp) {}

  /// @param frequency [Hz]
  /// @param phase [rad]
  void add(double amplitude, double frequency, double phase);
  void follow(Spline spline) { spline_ = std::move(spline); }

  bool moves() const { return spline_ || !terms_.empty(); }
  Jet at(double t) const;

  /// No |value|, no |rate| and no |acceleration| is greater: of harmonics the sum of all amplitudes, of a spline the
  /// greatest of ten points an interval.
  double greatest() const;
  double fastest() const;
  double greatest_acceleration() const;

 private:
  struct Term {
    double amplitude, omega, phase;
  };
  /// Without the ramp: of a derivative of the motion, `of` that of the spline.
  double greatest_of(double Jet::*of, int derivative) const;

  double ramp_;
  std::vector<Term> terms_;
  std::optional<Spline> spline_;
};

/// 10 s^3 - 15 s^4 + 6 s^5 with s = t/time: from 0 to 1, twice continuously differentiable also at its ends.
Jet smooth_step(double t, double time);

}  // namespace seiche::solver
