#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/motion/wave_speed.hpp"
#include "solver/particles/state.hpp"
#include "solver/pressure/linear_solver.hpp"
#include "solver/statistics.hpp"
#include "solver/step/time_step.hpp"

namespace seiche::solver {

/// Stops a run that has gone wrong, and says when, where and why.
template <int D>
class Watch {
 public:
  Watch(const Parameters& p, const Shape<D>& shape, const Motion& motion)
      : pressure_(p.pressure),
        speed_limit_(10 * (std::sqrt(2 * greatest_pull(p, shape.bounds(), motion) * shape.bounds().size().norm()) +
                           motion.fastest(reach_of(shape.bounds(), p.motion)))),
        cap_(step_cap(p, wave_speed(p, shape.bounds(), motion))) {}

  /// Greatest speed of the fluid [m/s]. Throws when one isn't finite, or beyond 10 (sqrt(2 a D) + tank speed), a the
  /// greatest pull, D the diagonal of the tank's bounds: ten times what a free fall through the whole tank gives.
  double check_motion(const State<D>& s) const {
    double fastest = 0;
    int finite = 1;
    const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static) reduction(max : fastest) reduction(min : finite)
    for (int i = 0; i < size; ++i) {
      const double v2 = s.velocity[i].squaredNorm();
      if (!std::isfinite(v2 + s.position[i].sum() + s.pressure[i])) finite = 0;
      fastest = std::max(fastest, v2);
    }
    fastest = std::sqrt(fastest);
    if (!finite) fail_not_finite(s);
    if (fastest > speed_limit_)
      fail(s, first(s, [&](int i) { return s.velocity[i].norm() > speed_limit_; }),
           fmt::format("the speed of {:.3g} m/s is beyond the limit of {:.3g} m/s", fastest, speed_limit_));
    return fastest;
  }

  /// Throws when the right-hand side of the pressure equation isn't finite.
  void check_source(const State<D>& s, bool finite) const {
    if (!finite) fail_not_finite(s);
  }

  /// Throws when the pressure solver did not converge.
  void check_solve(const State<D>& s, const SolveReport& report) const {
    if (!report.converged)
      throw RunFailure({s.time, s.step,
                        fmt::format("the pressure solver '{}' did not converge", name(pressure_.solver)),
                        fmt::format("{} iterations, relative residual {:.2g}, asked for {:.2g}", report.iterations,
                                    report.residual, pressure_.tolerance)});
  }

  /// Throws RunFailure, naming the first particle that isn't finite where there is one.
  [[noreturn]] void fail_not_finite(const State<D>& s) const {
    const int i = first(
        s, [&](int k) { return !std::isfinite(s.velocity[k].squaredNorm() + s.position[k].sum() + s.pressure[k]); });
    if (i < 0)
      throw RunFailure(
          {s.time, s.step, "the source of the pressure equation is not finite", "two particles in one place"});
    fail(s, i, "a velocity, position or pressure is not a finite number");
  }

  /// Throws when more than 5 % of the fluid has gone through the walls.
  void check_leaks(const State<D>& s, const Statistics& totals, long fluid_at_start) const {
    if (totals.leaked * 20 > fluid_at_start)
      throw RunFailure({s.time, s.step,
                        fmt::format("{} of {} fluid particles leaked through the walls, more than 5 %", totals.leaked,
                                    fluid_at_start)});
  }

  /// Throws when the step rule has stayed under 1e-3 of its cap for 100 steps; `short_steps` counts them.
  void check_step(const State<D>& s, double rule, int& short_steps) const {
    short_steps = std::isfinite(cap_) && rule < 1e-3 * cap_ ? short_steps + 1 : 0;
    if (short_steps >= 100)
      throw RunFailure(
          {s.time, s.step,
           fmt::format("the time step has been {:.2g} s, under a thousandth of its cap of {:.2g} s, for 100 steps",
                       rule, cap_)});
  }

 private:
  template <class F>
  static int first(const State<D>& s, F bad) {
    int found = -1;
    for (int i = 0; i < static_cast<int>(s.size()); ++i)
      if (bad(i) && (found < 0 || s.id[i] < s.id[found])) found = i;
    return found;
  }

  [[noreturn]] static void fail(const State<D>& s, int i, const std::string& why) {
    const Vec<D>& r = s.position[i];
    throw RunFailure({s.time, s.step, why, {}, Failure::Particle{s.kind[i], s.id[i], {r.data(), r.data() + D}}});
  }

  Parameters::Pressure pressure_;
  double speed_limit_, cap_;
};

}  // namespace seiche::solver
