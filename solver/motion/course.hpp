#pragma once
#include <optional>
#include <vector>

#include "solver/motion/spline.hpp"

namespace seiche::solver {

/// A measured motion: its spline, whose time `from` is the run's 0. Before its first sample and after its last it
/// stands still there where it is held, else it goes on as the spline does.
struct Record {
  Spline spline;
  double from = 0;  ///< [s]
  bool held = false;

  Jet at(double t) const;
};

/// How one degree of freedom moves: ramp(t) (sum of A sin(2 pi f t + phase) + record(t)).
class Course {
 public:
  /// @param ramp time over which the motion grows from nothing [s]; 0: it is there from the start
  explicit Course(double ramp) : ramp_(ramp) {}

  /// @param frequency [Hz]
  /// @param phase [rad]
  void add(double amplitude, double frequency, double phase);
  void follow(Record record) { record_ = std::move(record); }

  bool moves() const { return record_ || !terms_.empty(); }
  Jet at(double t) const;

  /// No |value|, no |rate| and no |acceleration| is greater: of harmonics the sum of all amplitudes, of a record the
  /// greatest of ten points an interval.
  double greatest() const;
  double fastest() const;
  double greatest_acceleration() const;

 private:
  struct Term {
    double amplitude, omega, phase;
  };
  /// Without the ramp: of a derivative of the motion, `of` that of the record.
  double greatest_of(double Jet::*of, int derivative) const;

  double ramp_;
  std::vector<Term> terms_;
  std::optional<Record> record_;
};

/// 10 s^3 - 15 s^4 + 6 s^5 with s = t/time: from 0 to 1, twice continuously differentiable also at its ends.
Jet smooth_step(double t, double time);

}  // namespace seiche::solver
