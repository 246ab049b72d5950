#pragma once
#include <cmath>

#include "solver/motion/motion.hpp"
#include "solver/particles/vec.hpp"
#include "solver/tank/level_axes.hpp"

namespace seiche::solver {

/// Force per mass on a particle at r that moves at u relative to the tank [m/s^2], in the tank's axes:
///   f = R^T (g - a) - w' x d - w x (w x d) - 2 w x u,   d = r - pivot,
/// a the acceleration of the pivot, w the angular velocity, w' its rate, R the orientation. All are means over a step
/// or belong to its middle. In 2-D w is along z.
template <int D>
struct BodyForce {
  using Matrix = Eigen::Matrix<double, D, D>;

  Vec<D> uniform = Vec<D>::Zero();      ///< R^T (g - a)
  bool rotates = false;                 ///< the rest is 0 where it doesn't
  Matrix of_position = Matrix::Zero();  ///< Euler and centrifugal force of d [1/s^2]
  Matrix of_velocity = Matrix::Zero();  ///< Coriolis force of u [1/s]
  Matrix of_gain = Matrix::Zero();      ///< Coriolis turn, within the step, of what it adds to the velocity [-]
  Vec<D> pivot = Vec<D>::Zero();        ///< [m]
  double divergence = 0;                ///< of the force over the liquid [1/s^2]

  Vec<D> operator()(const Vec<D>& r, const Vec<D>& u) const {
    if (!rotates) return uniform;
    return uniform + of_position * (r - pivot) + of_velocity * u;
  }
};

namespace detail {

/// The matrix of w x.
inline Eigen::Matrix3d cross(const Eigen::Vector3d& w) {
  Eigen::Matrix3d m;
  m << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
  return m;
}

}  // namespace detail

/// The body force of the step from t to t + dt. Accelerations are the means over the step, so that the velocity of a
/// free particle in a tank that doesn't rotate is exact whatever the step; orientation and angular velocity are those
/// of its middle.
///
/// The Coriolis force turns u by -2 w dt over a step, T, and what else acts, k, by half of that, H, on average:
///   u(t + dt) = T u(t) + H dt k + O(dt^3),   k = f + 2 w x u - grad p/rho.
/// `of_velocity` has (T - 1)/dt: u then keeps its length, whatever the step. `of_gain` has H - 1, for when k is known.
/// Without that turn liquid at rest in the lab, in a tank that spins, would lose its velocity at the rate w^2 dt/2.
template <int D>
BodyForce<D> body_force(const Motion& motion, const Gravity& gravity, double t, double dt) {
  const RigidState from = motion.state(t), to = motion.state(t + dt);
  const Eigen::Vector3d acceleration = (to.velocity - from.velocity) / dt;
  const Eigen::Vector3d uniform = Eigen::Vector3d(gravity[0], gravity[1], gravity[2]) - acceleration;
  BodyForce<D> force;
  if (!motion.rotates()) {
    force.uniform = uniform.head<D>();
    return force;
  }
  const RigidState middle = motion.state(t + 0.5 * dt);
  const Eigen::Quaterniond to_tank = middle.orientation.conjugate();
  const Eigen::Vector3d& w = middle.omega;
  const Eigen::Vector3d mean_alpha = (to.omega - from.omega) / dt;
  const Eigen::Matrix3d cross = detail::cross(w);
  force.rotates = true;
  force.uniform = (to_tank * uniform).template head<D>();
  force.of_position = (-detail::cross(mean_alpha) - cross * cross).template topLeftCorner<D, D>();
  const double rate = w.norm();
  if (rate > 0) {
    const auto turn_less_1 = [&](double angle) -> typename BodyForce<D>::Matrix {
      return (Eigen::AngleAxisd(-angle, w / rate).toRotationMatrix() - Eigen::Matrix3d::Identity())
          .template topLeftCorner<D, D>();
    };
    force.of_velocity = turn_less_1(2 * rate * dt) / dt;
    force.of_gain = turn_less_1(rate * dt);
  }
  force.pivot = middle.pivot.head<D>();
  // 2 w^2 + 2 w.zeta. Liquid keeps the vorticity that it has in the lab, 0 or that of a tank which it began to move
  // with: zeta = 2 (R^T w0 - w). What it gains beyond that leaves dt 2 w.zeta in the velocity, for the next step to
  // take.
  force.divergence = 2 * w.squaredNorm() + 4 * w.dot(to_tank * motion.spin_of_liquid() - w);
  return force;
}

/// The body force on liquid that is at rest in the tank.
template <int D>
BodyForce<D> body_force(const RelativeEquilibrium& at_rest) {
  BodyForce<D> force;
  const Eigen::Vector3d g(at_rest.gravity[0], at_rest.gravity[1], at_rest.gravity[2]);
  force.uniform = g.head<D>();
  if (at_rest.spin == 0) return force;
  const Eigen::Matrix3d cross = detail::cross(at_rest.spin / g.norm() * g);
  force.rotates = true;
  force.of_position = -(cross * cross).topLeftCorner<D, D>();
  force.pivot = Eigen::Vector3d(at_rest.pivot.data()).head<D>();
  force.divergence = 2 * at_rest.spin * at_rest.spin;
  return force;
}

/// Against gravity, in the axes of the tank at t; 0 where there is none.
template <int D>
Vec<D> up_in_tank(const Motion& motion, const Gravity& gravity, double t) {
  if (gravity.size() == 0) return Vec<D>::Zero();
  return (motion.state(t).orientation.conjugate() * LevelAxes<3>(gravity).up()).template head<D>();
}

/// Velocity relative to the tank of liquid at rest in the lab at t = 0, as the "force" that gives it within dt.
template <int D>
BodyForce<D> start_force(const Motion& motion, double dt) {
  const RigidState start = motion.state(0);
  BodyForce<D> force;
  force.uniform = (start.orientation.conjugate() * (-start.velocity / dt)).template head<D>();
  force.rotates = motion.rotates();
  force.of_position = (-detail::cross(start.omega) / dt).template topLeftCorner<D, D>();
  force.pivot = start.pivot.head<D>();
  return force;
}

}  // namespace seiche::solver
