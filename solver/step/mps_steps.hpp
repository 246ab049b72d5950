#pragma once
#include <utility>

#include "solver/pressure/boundary.hpp"
#include "solver/step/mps.hpp"

// The steps of Mps, apart from the class so that each dimension is compiled once, in its own file.
namespace seiche::solver {

template <int D>
Mps<D>::Mps(const Parameters& p, double sample_interval)
    : p_(p),
      motion_(p.motion),
      box_(p),
      l0_(p.particles.spacing),
      density_range_(p, p.method.radius_density),
      gradient_range_(p, p.method.radius_gradient),
      laplacian_range_(p, p.method.radius_laplacian),
      run_{.particles = fill_tank<D>(p)},
      // A skin of 0.3 l0 balances the cost of longer rows against that of making the list more often.
      list_(Vec<D>::Constant(-wall_layers(p.method) * l0_), box_.size.array() + wall_layers(p.method) * l0_,
            longest_support(p.method) * l0_, 0.3 * l0_),
      solver_(make_pressure_solver(p.pressure.solver, p.pressure.tolerance, p.pressure.max_iterations)),
      sensors_(p, sample_interval, s_),
      watch_(p, motion_),
      wetness_(std::visit([&](auto w) { return WallWetness<D>(w, l0_); }, density_range_.w)),
      volume_kernel_(l0_),
      whole_volume_(1 + lattice_reference<D>(volume_kernel_, l0_).n0),
      surface_depth_(std::visit([&](auto w) { return surface_depth<D>(w, l0_); }, density_range_.w)) {
  if (p.method.radius_gradient == p.method.radius_density) gradient_range_.pairs = density_range_.pairs;
  if (p.method.radius_laplacian == p.method.radius_density) laplacian_range_.pairs = density_range_.pairs;
  for (Kind k : s_.kind)
    ++(k == Kind::fluid ? totals_.fluid_particles : k == Kind::wall ? totals_.wall_particles : totals_.dummy_particles);
  run_.fluid_at_start = totals_.fluid_particles;
  refresh_neighbours();
  measure_pairs();
  find_surface();
  if (const StandingWave wave(p); p.fluid.wave_amplitude != 0)
    each_fluid([&](int i) { s_.velocity[i] = wave.velocity<D>(s_.position[i]); });
  if (motion_.jumps()) start_at_rest_in_lab();
  run_.fastest = watch_.check_motion(s_);
  sensors_.read(s_, run_.sensors);
}

template <int D>
FramePtr Mps<D>::frame(long index) {
  auto frame = snapshot(s_, density_range_.ref.n0, motion_);
  frame->index = index;
  frame->readings = std::exchange(run_.sensors.readings, {});
  Pairs<D> pairs;  // the state's are those of the step's start
  std::visit([&](auto w) { pairs.measure(w, list_, s_); }, gradient_range_.w);
  derive(pairs, gradient_range_.ref.n0, s_, *frame);
  return frame;
}

template <int D>
void Mps<D>::resume(const RunState<D>& state) {
  run_ = state;
  // The list as it was: particles lie in its order already, so that none changes place.
  s_.position = state.particles.listed_position;
  list_neighbours();
  s_.position = state.particles.position;
}

template <int D>
void Mps<D>::step(double until) {
  const double rule = step_rule(p_, run_.fastest);
  watch_.check_step(s_, rule, run_.short_steps);
  const double dt = split_evenly(until - s_.time, rule);
  const double end = s_.time + 1.5 * dt > until ? until : s_.time + dt;
  {
    const Stage stage(totals_.seconds["sensors"]);
    sensors_.before_step(s_, end, run_.sensors);
  }
  if (p_.method.order == Order::move_first)
    step_move_first(dt);
  else
    step_project_first(dt);
  s_.time = end;
  ++s_.step;
  totals_.steps = s_.step;
  totals_.shortest_step = s_.step == 1 ? dt : std::min(totals_.shortest_step, dt);
  totals_.longest_step = std::max(totals_.longest_step, dt);
  take_out_lost();
  run_.fastest = watch_.check_motion(s_);
  watch_.check_leaks(s_, totals_, run_.fluid_at_start);
  const Stage stage(totals_.seconds["sensors"]);
  sensors_.read(s_, run_.sensors);
}

/// The paper's order: predict and move (12-14), part close pairs, number density and pressure (3, 10), correct (15-17).
template <int D>
void Mps<D>::step_move_first(double dt) {
  refresh_neighbours();
  measure_pairs();
  predict(dt);
  move_fluid([&](int i) { return Vec<D>(dt * s_.velocity[i]); });
  refresh_neighbours();
  separate();
  refresh_neighbours();
  measure_pairs();
  find_surface();
  solve_pressure(dt, p_.fluid.density);
  clip_pressure();
  correct_velocity(dt);
  move_fluid([&](int i) { return Vec<D>(dt * change_[i]); });
}

/// The stabilised order: predict (12, 13), project with the weights of the positions at the step's start, then move
/// with the new velocity, and keep particles apart. That is the symplectic Euler method: a wave of frequency omega
/// keeps its height, where a move with the mean of old and new velocity lets it grow by omega^2 dt/4 in time.
template <int D>
void Mps<D>::step_project_first(double dt) {
  refresh_neighbours();
  measure_pairs();
  find_surface();
  predict(dt);
  solve_pressure(dt, p_.fluid.density);
  clip_pressure();
  correct_velocity(dt);
  const double share = p_.method.shift * dt * std::sqrt(p_.gravity * p_.fluid.depth) / l0_;
  particle_shift(*density_range_.pairs, density_range_.ref.n0, share, l0_, s_.near_surface, s_, change_);
  move_fluid([&](int i) { return Vec<D>(dt * s_.velocity[i] + change_[i]); });
  separate();
}

/// u* = u + dt (nu Laplacian(u) + f), equations (12) and (13); f is gravity less the inertial forces of the tank's
/// frame.
template <int D>
void Mps<D>::predict(double dt) {
  const Stage stage(totals_.seconds["explicit"]);
  const bool slip = p_.method.wall == WallSlip::free;
  if (p_.method.viscous == ViscousModel::laplacian)
    velocity_laplacian(*laplacian_range_.pairs, laplacian_range_.ref, slip, s_, viscous_);
  else
    strain_rate_divergence(*laplacian_range_.pairs, laplacian_range_.ref, slip, s_, viscous_);
  set_force(body_force<D>(motion_, p_.gravity, s_.time, dt));
  // Ghost walls balance f in the pressure equation itself, so there it joins the velocity only after the projection.
  const bool now = !ghost_walls();
  each_fluid([&](int i) {
    viscous_[i] *= p_.fluid.viscosity;
    s_.velocity[i] += dt * (viscous_[i] + (now ? force_[i] : Vec<D>(Vec<D>::Zero())));
  });
}

template <int D>
void Mps<D>::set_force(const BodyForce<D>& force) {
  force_.resize(s_.size());
  slope_.resize(s_.size());
  force_divergence_ = force.divergence;
  each_fluid([&](int i) {
    force_[i] = force(s_.position[i], s_.velocity[i]);
    slope_[i] = p_.fluid.density * force_[i];
  });
}

template <int D>
void Mps<D>::refresh_neighbours() {
  const Stage stage(totals_.seconds["search"]);
  if (!list_.is_stale(s_)) return;
  list_neighbours();
  ++totals_.list_builds;
}

template <int D>
void Mps<D>::list_neighbours() {
  list_.build(s_);
  wetness_.relist(list_, s_);
  for (Scalars* values : {&excess_, &divergence_}) values->resize(s_.size());
  for (std::vector<int>* values : {&count_, &collisions_}) values->resize(s_.size());
  for (Vecs<D>* values : {&change_, &viscous_}) values->resize(s_.size());
}

/// Measures all pairs at the present positions.
template <int D>
void Mps<D>::measure_pairs() {
  const Stage stage(totals_.seconds["pairs"]);
  const auto measure = [&](const Range<D>& range) {
    std::visit([&](auto w) { range.pairs->measure(w, list_, s_); }, range.w);
  };
  measure(density_range_);
  totals_.least_distance = std::min(totals_.least_distance, density_range_.pairs->least_distance());
  if (gradient_range_.pairs != density_range_.pairs) measure(gradient_range_);
  if (laplacian_range_.pairs != density_range_.pairs) measure(laplacian_range_);
}

/// Number density (3) and free surface (11).
template <int D>
void Mps<D>::find_surface() {
  const Stage stage(totals_.seconds["density"]);
  if (ghost_walls()) wetness_(*density_range_.pairs, density_range_.ref.n0, s_);
  number_density(*density_range_.pairs, s_, s_.density, count_);
  const double share = p_.method.surface == SurfaceTest::density ? 0 : count_share;
  mark_free_surface(density_range_.ref, p_.method.surface_beta, share, s_.density, count_, s_.kind, s_.surface);
  mark_near_surface(*density_range_.pairs, s_, s_.near_surface);
}

/// Solves equation (10) for the pressure at the end of the step.
/// @param surface_density rho of the pressure's slope below the free surface, for ghost walls; 0: p = 0 there
template <int D>
void Mps<D>::solve_pressure(double dt, double surface_density) {
  const int size = static_cast<int>(s_.size());
  {
    const Stage stage(totals_.seconds["assembly"]);
    if (ghost_walls()) {
      set_surface_pressure(surface_density, force_, viscous_, surface_depth_, s_.density, s_);
      assemble(
          GhostBoundary<D>{s_, s_.density, s_.near_surface, density_range_.ref.n0, laplacian_range_.ref.n0, slope_},
          dt);
    } else {
      assemble(PaperBoundary<D>{s_}, dt);
    }
  }
  const Stage stage(totals_.seconds["solve"]);
  solve_system();
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    if (system_.row(i) >= 0)
      s_.pressure[i] = solution_[system_.row(i)];
    else if (!ghost_walls() || s_.kind[i] != Kind::fluid)
      s_.pressure[i] = 0;
  }
  if (ghost_walls()) extend_to_walls(*density_range_.pairs, slope_, s_);
}

/// Negative pressures become 0: particles that pull at each other clump.
template <int D>
void Mps<D>::clip_pressure() {
  for (double& pressure : s_.pressure) pressure = std::max(0.0, pressure);
}

template <int D>
template <class Boundary>
void Mps<D>::assemble(const Boundary& boundary, double dt) {
  const Source source(p_, dt);
  const Reference& ref = laplacian_range_.ref;
  const double scale = ref.lambda * ref.n0 / (2 * D), n0 = density_range_.ref.n0;
  if (source.mixed) {
    velocity_divergence(*density_range_.pairs, n0, s_, divergence_);
    volume_excess(volume_kernel_, whole_volume_, list_, s_, excess_);
  }
  system_.assemble(*laplacian_range_.pairs, definite * ref.n0, boundary, s_);
  resize_kept(solution_, system_.rows());
#pragma omp parallel for schedule(static)
  for (int k = 0; k < system_.rows(); ++k) {
    const int i = system_.particle(k);
    const double excess = source.mixed ? excess_[i] : (s_.density[i] - n0) / n0;
    system_.rhs()[k] += scale * source(divergence_[i] + dt * force_divergence_, excess, s_.near_surface[i]);
    solution_[k] = s_.pressure[i];
  }
}

template <int D>
void Mps<D>::solve_system() {
  if (system_.rows() == 0) return;
  if (!system_.rhs().allFinite()) watch_.fail_not_finite(s_);
  const SolveReport report =
      solver_->solve(system_.matrix(), system_.rhs(), VectorView(solution_.data(), system_.rows()));
  totals_.iterations += report.iterations;
  totals_.last_iterations = report.iterations;
  totals_.last_residual = report.residual;
  totals_.worst_residual = std::max(totals_.worst_residual, report.residual);
  if (!report.converged)
    throw RunFailure({s_.time, s_.step,
                      fmt::format("the pressure solver '{}' did not converge", name(p_.pressure.solver)),
                      fmt::format("{} iterations, relative residual {:.2g}, asked for {:.2g}", report.iterations,
                                  report.residual, p_.pressure.tolerance)});
}

/// u = u* - dt/rho grad p, equations (15) and (16); leaves the change of velocity in `change_`.
template <int D>
void Mps<D>::correct_velocity(double dt) {
  const Stage stage(totals_.seconds["gradient"]);
  const auto gradient = [&](auto model) {
    pressure_gradient(model, *gradient_range_.pairs, gradient_range_.ref.n0, ghost_walls() ? &slope_ : nullptr, s_,
                      change_);
  };
  if (p_.method.gradient == GradientModel::corrected) gradient(CorrectedGradient{});
  if (p_.method.gradient == GradientModel::minimum) gradient(MinimumGradient{});
  if (p_.method.gradient == GradientModel::plain) gradient(PlainGradient{});
  each_fluid([&](int i) {
    change_[i] *= -dt / p_.fluid.density;
    if (ghost_walls()) change_[i] += dt * force_[i];
    s_.velocity[i] += change_[i];
  });
}

template <int D>
void Mps<D>::separate() {
  const Stage stage(totals_.seconds["separate"]);
  const double distance = p_.method.separation_distance * l0_;
  if (p_.method.separation == SeparationModel::part) part_close_pairs(distance, list_, s_, change_);
  if (p_.method.separation == SeparationModel::collide)
    collide_close_pairs(distance, l0_, s_.near_surface, list_, s_, collisions_, change_);
}

/// Removes fluid that went through a wall or over the rim, and counts it.
template <int D>
void Mps<D>::take_out_lost() {
  long leaked = 0, spilled = 0;
  std::vector<int> kept;
  const int size = static_cast<int>(s_.size());
  for (int i = 0; i < size; ++i) {
    if (s_.kind[i] != Kind::fluid) continue;
    const bool over = box_.has_spilled(s_.position[i]);
    spilled += over;
    leaked += !over && box_.has_leaked(s_.position[i]);
  }
  if (leaked + spilled == 0) return;
  for (int i = 0; i < size; ++i)
    if (s_.kind[i] != Kind::fluid || !(box_.has_spilled(s_.position[i]) || box_.has_leaked(s_.position[i])))
      kept.push_back(i);
  s_.reorder(kept);
  totals_.leaked += leaked;
  totals_.spilled += spilled;
  totals_.fluid_particles -= leaked + spilled;
  s_.listed_position.clear();
  refresh_neighbours();
  measure_pairs();
  find_surface();
}

/// Impulsive start: relative to the tank, liquid at rest in the lab moves at -(v + w k x d). Between ghost walls that
/// jump is an impulse, a force over one step of length dt without gravity, and the velocity that it leaves, whatever
/// dt, is projected; its pressure, which no finite step could report, is forgotten.
template <int D>
void Mps<D>::start_at_rest_in_lab() {
  const double dt = step_cap(p_);
  set_force(start_force<D>(motion_, dt));
  if (!ghost_walls()) return each_fluid([&](int i) { s_.velocity[i] += dt * force_[i]; });
  const Scalars still = s_.pressure;
  std::fill(s_.pressure.begin(), s_.pressure.end(), 0);
  solve_pressure(dt, 0);
  correct_velocity(dt);
  s_.pressure = still;
}

}  // namespace seiche::solver
