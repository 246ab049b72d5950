#pragma once
#include "solver/step/mps.hpp"

// The method: its two orders of a step, and then each stage. Mps::step() takes them in turn (mps_run.hpp).
namespace seiche::solver {

/// The paper's order: predict and move (12-14), part close pairs, number density and pressure (3, 10), correct (15-17).
template <int D>
void Mps<D>::step_move_first(double dt) {
  find_neighbours();
  predict(body(dt), dt);
  move_fluid([&](int i) { return Vec<D>(dt * s_.velocity[i]); });
  list_neighbours();
  separate();
  find_neighbours();
  find_surface();
  solve_pressure(dt, p_.fluid.density);
  clip_pressure();
  correct(dt);
  move_fluid([&](int i) { return Vec<D>(dt * change_[i]); });
}

/// The stabilised order: predict (12, 13), project with the weights of the positions at the step's start, then move
/// with the new velocity, and keep particles apart. That is the symplectic Euler method: a wave of frequency omega
/// keeps its height, where a move with the mean of old and new velocity lets it grow by omega^2 dt/4 in time.
template <int D>
void Mps<D>::step_project_first(double dt) {
  find_neighbours();
  find_surface();
  const BodyForce<D> force = body(dt);
  turn(force, dt);
  predict(force, dt);
  solve_pressure(dt, p_.fluid.density);
  clip_pressure();
  correct(dt);
  shift_(near_.density, dt, s_, change_);
  move_fluid([&](int i) { return Vec<D>(dt * s_.velocity[i] + change_[i]); });
  carry_velocity();
  turn_gain(force);
  separate();
}

/// Where particle i comes to on its way to a place: l0/20 before the first side of a baffle that it would enter, and
/// there it moves along that. What would enter another on that way stays where it is.
template <int D>
Vec<D> Mps<D>::stopped_at_baffles(int i, Vec<D> to) {
  const Vec<D>& from = s_.position[i];
  const int face = s_.baffles->entered(from, to);
  if (face < 0) return to;
  const BaffleFace<D>& side = s_.baffles->faces()[face];
  const Vec<D> normal = side.normal_at(to);
  to -= (side.behind(to) + 0.05 * p_.particles.spacing) * normal;
  s_.velocity[i] -= std::max(0.0, s_.velocity[i].dot(normal)) * normal;
  return s_.baffles->entered(from, to) < 0 ? to : from;
}

template <int D>
void Mps<D>::list_neighbours() {
  const Stage stage(totals_.seconds["search"]);
  if (!near_.list.is_stale(s_)) return;
  near_.list.build(s_);
  walls_->relist(near_.list, s_);
  ++totals_.list_builds;
}

template <int D>
void Mps<D>::find_neighbours() {
  list_neighbours();
  const Stage stage(totals_.seconds["pairs"]);
  near_.measure(s_);
  totals_.least_distance = std::min(totals_.least_distance, near_.density.pairs->least_distance());
}

/// Number density (3) and free surface (11), walls as far as they are wet.
template <int D>
void Mps<D>::find_surface() {
  const Stage stage(totals_.seconds["density"]);
  walls_->wet(near_.density, up(), s_);
  surface_(near_.density, s_);
}

/// u* = u + dt (nu Laplacian(u) + f), equations (12) and (13); f is gravity less the inertial forces of the tank's
/// frame. Where the pressure equation balances f, that joins the velocity only after the projection.
template <int D>
void Mps<D>::predict(const BodyForce<D>& force, double dt) {
  const Stage stage(totals_.seconds["explicit"]);
  viscosity_(near_.laplacian, s_, forces_.viscous);
  forces_.set_body(force, p_.fluid.density, s_);
  const bool now = !walls_->slope(forces_);
  if (!now) bend_slope();
  each_fluid(s_, [&](int i) {
    s_.velocity[i] += dt * (forces_.viscous[i] + (now ? forces_.body[i] : Vec<D>(Vec<D>::Zero())));
  });
}

/// Behind walls that bend the pressure's slope leaves liquid the acceleration by which it follows them: the nearest,
/// and in a corner also the other.
template <int D>
void Mps<D>::bend_slope() {
  const double l0 = p_.particles.spacing, reach = p_.method.radius_laplacian * l0;
  each_fluid(s_, [&](int i) {
    const auto bend_at = [&](const Vec<D>& r) {
      forces_.slope[i] -= p_.fluid.density * turn_along_wall(*tank_, r, s_.velocity[i], l0);
    };
    const Nearest<D> wall = tank_->nearest(s_.position[i]);
    if (-wall.distance > reach) return;
    bend_at(s_.position[i]);
    if (const auto other = before_other_wall(i, wall.normal)) bend_at(*other);
  });
}

/// Of the tank's walls around particle i that stand at an angle of more than 30 degrees to the one with this normal the
/// nearest: a point l0/10 before it, beside the particle.
template <int D>
std::optional<Vec<D>> Mps<D>::before_other_wall(int i, const Vec<D>& normal) const {
  const double l0 = p_.particles.spacing;
  const Vec<D>& r = s_.position[i];
  double least = std::numeric_limits<double>::infinity();
  std::optional<Vec<D>> found;
  for (int j : near_.list[i]) {
    const Vec<D>& other = s_.normal[j];
    if (s_.kind[j] != Kind::wall || s_.behind[j] >= 0 || other.isZero() || other.dot(normal) > cosine_of_corner)
      continue;
    const double depth = other.dot(s_.position[j] - r);  // of the wall particle, l0/2 behind the wall
    if (depth < least) least = depth, found = r + (depth - 0.6 * l0) * other;
  }
  return found;
}

/// Solves equation (10) for the pressure at the end of the step.
/// @param surface_density rho of the pressure's slope below the free surface; 0: p = 0 there
template <int D>
void Mps<D>::solve_pressure(double dt, double surface_density) {
  {
    const Stage stage(totals_.seconds["assembly"]);
    equation_.assemble(*walls_, near_, forces_, surface_density, dt, s_);
  }
  const Stage stage(totals_.seconds["solve"]);
  watch_.check_source(s_, equation_.is_finite());
  const SolveReport report = equation_.solve(s_);
  totals_.iterations += report.iterations;
  totals_.last_iterations = report.iterations;
  totals_.last_residual = report.residual;
  totals_.worst_residual = std::max(totals_.worst_residual, report.residual);
  watch_.check_solve(s_, report);
  walls_->extend_pressure(near_.density, forces_, s_);
}

/// Negative pressures become 0: particles that pull at each other clump.
template <int D>
void Mps<D>::clip_pressure() {
  for (double& pressure : s_.pressure) pressure = std::max(0.0, pressure);
}

/// u = u* - dt/rho grad p, equations (15) and (16); leaves the change of velocity in `change_`.
template <int D>
void Mps<D>::correct(double dt) {
  const Stage stage(totals_.seconds["gradient"]);
  const Vecs<D>* slope = walls_->slope(forces_);
  gradient_(near_.gradient, slope, s_, change_);
  each_fluid(s_, [&](int i) {
    change_[i] *= -dt / p_.fluid.density;
    if (slope) change_[i] += dt * forces_.body[i];
    s_.velocity[i] += change_[i];
  });
}

/// Remembers the velocity that the step would leave were there the Coriolis force alone.
template <int D>
void Mps<D>::turn(const BodyForce<D>& force, double dt) {
  if (!force.rotates) return;
  resize_kept(turned_, s_.size());
  each_fluid(s_, [&](int i) { turned_[i] = s_.velocity[i] + dt * (force.of_velocity * s_.velocity[i]); });
}

/// The Coriolis turn of what else the step has added to the velocity (body_force.hpp).
template <int D>
void Mps<D>::turn_gain(const BodyForce<D>& force) {
  if (!force.rotates) return;
  each_fluid(s_, [&](int i) { s_.velocity[i] += force.of_gain * (s_.velocity[i] - turned_[i]); });
}

/// A shifted particle takes the velocity of the liquid where it comes to, as far as that turns there: u + W r by the
/// antisymmetric part W of its gradient (Lind, Xu, Stansby, Rogers 2012 take all of it). Else liquid at rest in the lab
/// would be stirred in a tank that spins. By the rest of the gradient a particle that rises beside a floor, shifted
/// back all the while, would rise ever faster.
template <int D>
void Mps<D>::carry_velocity() {
  const VelocityGradients<D>& gradient = equation_.velocity_gradient();
  if (gradient.empty()) return;
  each_fluid(s_, [&](int i) { s_.velocity[i] += 0.5 * (gradient[i] - gradient[i].transpose()) * change_[i]; });
}

template <int D>
void Mps<D>::separate() {
  const Stage stage(totals_.seconds["separate"]);
  separation_([&](const Vec<D>& r) { return tank_->nearest(r); }, near_.list, s_);
}

}  // namespace seiche::solver
