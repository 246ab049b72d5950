#pragma once
#include <utility>

#include "solver/modes/standing_wave.hpp"
#include "solver/preset.hpp"
#include "solver/step/derived.hpp"
#include "solver/step/mps.hpp"
#include "solver/step/snapshot.hpp"
#include "solver/tank/filling.hpp"
#include "solver/tank/lost_particles.hpp"
#include "solver/tank/pools.hpp"

// A run of Mps: how it starts, takes a step, hands out frames and goes on from a state.
namespace seiche::solver {

template <int D>
Mps<D>::Mps(const Parameters& p, double sample_interval)
    : p_(p),
      motion_(p.motion),
      tank_(make_shape<D>(p)),
      wave_speed_(wave_speed(p, tank_->bounds(), motion_)),
      at_rest_(equilibrium_at_start(p)),
      run_{.particles = fill_tank<D>(p, *tank_, at_rest_)},
      near_(p, tank_->bounds().low.array() - wall_layers(p.method) * p.particles.spacing,
            tank_->bounds().high.array() + wall_layers(p.method) * p.particles.spacing, longest_support(p.method)),
      walls_(make_walls<D>(p, near_.density.w)),
      surface_(p.method),
      viscosity_(p),
      equation_(p, wave_speed_),
      gradient_(p.method.gradient),
      shift_(p, wave_speed_),
      separation_(p),
      sensors_({p_, *tank_, s_}, sample_interval),
      watch_(p, *tank_, motion_) {
  count_kinds();
  find_neighbours();
  find_surface();
  settle();
  if (p.fluid.wave_amplitude != 0) {
    const modes::StandingWave wave(p, tank_->bounds().size()[0]);
    each_fluid(s_, [&](int i) { s_.velocity[i] = wave.velocity<D>(s_.position[i]); });
  }
  if (motion_.jumps()) start_at_rest_in_lab();
  run_.fastest = watch_.check_motion(s_);
  sensors_.read(s_, run_.sensors);
}

/// Where walls cut the cells of the lattice, particles begin unevenly: they become even before the run.
template <int D>
void Mps<D>::settle() {
  if (wave_speed_ == 0) return;
  const double specific = still_pressure(p_.fluid.density, at_rest_.gravity, 1, 0);  // 0: pressures are 0
  const LevelAxes<D> axes(at_rest_);
  Scalars level(s_.size());  // by particles' numbers
  each_fluid(s_, [&](int i) {
    level[s_.id[i]] = axes.height(s_.position[i]) + (specific > 0 ? s_.pressure[i] / specific : 0);
  });
  if (!(p_.method.order == Order::project_first ? even_out() : take_even_places())) return;
  find_neighbours();
  find_surface();
  each_fluid(
      s_, [&](int i) { s_.pressure[i] = std::max(0.0, specific * (level[s_.id[i]] - axes.height(s_.position[i]))); });
}

/// In the first steps they would even out by themselves: of the velocities with which they do so the pressure takes
/// back only what compresses, and the rest would go round near the wall for seconds, at up to a twentieth of sqrt(g H).
/// So they do it at rest under what acts at t = 0, for the time in which a long wave goes as far as the liquid is deep,
/// in steps whose velocities are forgotten. Returns whether they weren't even.
template <int D>
bool Mps<D>::even_out() {
  const double l0 = p_.particles.spacing, dt = step_cap(p_, wave_speed_);
  shift_(near_.density, dt, s_, change_);
  if (std::all_of(change_.begin(), change_.end(), [&](const Vec<D>& by) { return by.norm() < 1e-6 * l0; }))
    return false;
  const Statistics totals = totals_;
  settling_ = true;
  const long steps = std::lround(std::ceil(p_.fluid.depth / (p_.time.courant * l0)));
  for (long k = 0; k < steps; ++k) {
    step_project_first(dt);
    each_fluid(s_, [&](int i) { s_.velocity[i].setZero(); });
  }
  settling_ = false;
  totals_ = totals;
  return true;
}

/// The paper's order doesn't shift particles: they begin where the stabilised preset's are when they have become even.
/// Returns whether that is elsewhere: not where no wall cuts a cell.
template <int D>
bool Mps<D>::take_even_places() {
  const auto is_whole = [](const auto& part) { return part.inside.share == 1; };
  const auto pools = pools_of(p_, *tank_, at_rest_);
  if (!s_.baffles && std::all_of(pools.begin(), pools.end(), [&](const Pool<D>& pool) {
        return std::all_of(pool.parts.begin(), pool.parts.end(), is_whole);
      }))
    return false;
  Parameters p = p_;
  apply_preset(p, Preset::stabilised);
  const Mps<D> even(p, 0);
  Vecs<D> places(even.s_.size());
  each_fluid(even.s_, [&](int i) { places[even.s_.id[i]] = even.s_.position[i]; });
  bool moved = false;
  for (std::size_t i = 0; i < s_.size(); ++i) {
    if (s_.kind[i] != Kind::fluid || s_.position[i] == places[s_.id[i]]) continue;
    s_.position[i] = places[s_.id[i]];
    moved = true;
  }
  return moved;
}

template <int D>
void Mps<D>::count_kinds() {
  for (Kind k : s_.kind)
    ++(k == Kind::fluid ? totals_.fluid_particles : k == Kind::wall ? totals_.wall_particles : totals_.dummy_particles);
  run_.fluid_at_start = totals_.fluid_particles;
}

/// Impulsive start: relative to the tank, liquid at rest in the lab moves at -(v + w k x d). Where the pressure
/// equation balances the body force, that jump is an impulse, a force over one step of length dt without gravity, and
/// the velocity that it leaves, whatever dt, is projected; its pressure, which no finite step could report, is
/// forgotten.
template <int D>
void Mps<D>::start_at_rest_in_lab() {
  const double dt = step_cap(p_, wave_speed_);
  forces_.set_body(start_force<D>(motion_, dt), p_.fluid.density, s_);
  if (!walls_->slope(forces_)) return each_fluid(s_, [&](int i) { s_.velocity[i] += dt * forces_.body[i]; });
  forces_.viscous.assign(s_.size(), Vec<D>::Zero());
  const Scalars still = s_.pressure;
  std::fill(s_.pressure.begin(), s_.pressure.end(), 0);
  solve_pressure(dt, 0);
  correct(dt);
  s_.pressure = still;
}

template <int D>
void Mps<D>::step(double until) {
  const double rule = step_rule(p_, wave_speed_, run_.fastest);
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
  remove_lost();
  run_.fastest = watch_.check_motion(s_);
  watch_.check_leaks(s_, totals_, run_.fluid_at_start);
  const Stage stage(totals_.seconds["sensors"]);
  sensors_.read(s_, run_.sensors);
}

/// Removes fluid that went through a wall or over the rim, and counts it.
template <int D>
void Mps<D>::remove_lost() {
  const auto [leaked, spilled] = take_out_lost(*tank_, p_.particles.spacing, s_);
  if (leaked + spilled == 0) return;
  totals_.leaked += leaked;
  totals_.spilled += spilled;
  totals_.fluid_particles -= leaked + spilled;
  s_.listed_position.clear();
  find_neighbours();
  find_surface();
}

template <int D>
FramePtr Mps<D>::frame(long index) {
  auto frame = snapshot(s_, near_.density.ref.n0, motion_);
  frame->index = index;
  frame->readings = std::exchange(run_.sensors.readings, {});
  Pairs<D> pairs;  // those of the stages are of the step's start
  std::visit([&](auto w) { pairs.measure(w, near_.list, s_); }, near_.gradient.w);
  derive(pairs, near_.gradient.ref.n0, s_, *frame);
  return frame;
}

template <int D>
void Mps<D>::resume(const RunState<D>& state) {
  run_ = state;
  // The list as it was: particles lie in its order already, so that none changes place.
  s_.position = state.particles.listed_position;
  near_.list.build(s_);
  walls_->relist(near_.list, s_);
  s_.position = state.particles.position;
}

}  // namespace seiche::solver
