#pragma once
#include <cmath>

#include "solver/motion/motion.hpp"
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Force per mass on a particle at r that moves at u relative to the tank [m/s^2], in the tank's axes:
///   f = R^T (g - a) + w^2 d - w' k x d - 2 w k x u,   d = r - pivot in the plane of x and y,
/// a the acceleration of the pivot, w the roll rate, w' its rate, R the rotation by the roll angle, k along z. All are
/// means over a step or belong to its middle.
template <int D>
struct BodyForce {
  Vec<D> uniform = Vec<D>::Zero();  ///< R^T (g - a)
  bool turns = false;               ///< the rest is 0 where it doesn't
  double centrifugal = 0;           ///< w^2 [1/s^2]
  double euler = 0;                 ///< w' [1/s^2]
  /// The Coriolis force turns u by -2 w dt over a step. That turn itself over dt, and not -2 w k x u, is what acts: u
  /// then keeps its length, whatever the step. (cos - 1)/dt and sin/dt of the angle [1/s].
  double turned_along = 0, turned_across = 0;
  double pivot_x = 0, pivot_y = 0;  ///< [m]
  double divergence = 0;            ///< of the force over the liquid [1/s^2]

  Vec<D> operator()(const Vec<D>& r, const Vec<D>& u) const {
    if (!turns) return uniform;
    Vec<D> f = uniform;
    const double x = r[0] - pivot_x, y = r[1] - pivot_y;
    f[0] += centrifugal * x + euler * y + turned_along * u[0] - turned_across * u[1];
    f[1] += centrifugal * y - euler * x + turned_along * u[1] + turned_across * u[0];
    return f;
  }
};

namespace detail {

/// R^T (x, y), for a roll by `angle`.
template <int D>
Vec<D> in_tank(double x, double y, double angle) {
  Vec<D> result = Vec<D>::Zero();
  const double c = std::cos(angle), s = std::sin(angle);
  result[0] = c * x + s * y;
  result[1] = c * y - s * x;
  return result;
}

}  // namespace detail

/// The body force of the step from t to t + dt. Accelerations are the means over the step, so that the velocity of a
/// free particle in a tank that doesn't roll is exact whatever the step; the angle and the roll rate are those of its
/// middle. A free particle in a rolling tank is followed to first order in dt.
template <int D>
BodyForce<D> body_force(const Motion& motion, double gravity, double t, double dt) {
  const auto mean = [dt](const Jet& from, const Jet& to) { return (to.rate - from.rate) / dt; };
  const double x = -mean(motion.surge(t), motion.surge(t + dt)), y = -mean(motion.heave(t), motion.heave(t + dt));
  BodyForce<D> force;
  if (!motion.rolls()) {
    force.uniform[0] = x;
    force.uniform[1] = y - gravity;
    return force;
  }
  const Jet middle = motion.roll(t + 0.5 * dt);
  const double rate = middle.rate;
  force.uniform = detail::in_tank<D>(x, y - gravity, middle.value);
  force.turns = true;
  force.centrifugal = rate * rate;
  force.euler = mean(motion.roll(t), motion.roll(t + dt));
  force.turned_along = (std::cos(2 * rate * dt) - 1) / dt;
  force.turned_across = -std::sin(2 * rate * dt) / dt;
  force.pivot_x = motion.pivot_x();
  force.pivot_y = motion.pivot_y();
  // 2 w^2 + 2 w zeta. Liquid keeps the vorticity that it has in the lab, 0 or that of a tank which it began to move
  // with: zeta = 2 (w0 - w). What it gains beyond that leaves dt 2 w zeta in the velocity, for the next step to take.
  force.divergence = 2 * rate * rate + 4 * rate * (motion.spin_of_liquid() - rate);
  return force;
}

/// Velocity relative to the tank of liquid at rest in the lab at t = 0, as the "force" that gives it within dt.
template <int D>
BodyForce<D> start_force(const Motion& motion, double dt) {
  const Jet roll = motion.roll(0);
  BodyForce<D> force;
  force.uniform = detail::in_tank<D>(-motion.surge(0).rate / dt, -motion.heave(0).rate / dt, roll.value);
  force.turns = motion.rolls();
  force.euler = roll.rate / dt;
  force.pivot_x = motion.pivot_x();
  force.pivot_y = motion.pivot_y();
  return force;
}

}  // namespace seiche::solver
