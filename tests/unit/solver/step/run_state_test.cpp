#include "solver/step/run_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/preset.hpp"
#include "solver/step/mps.hpp"
#include "tests/unit/solver/surging.hpp"

namespace seiche::solver {
namespace {

constexpr double interval = 1. / 60;

template <int D>
void step_to(Mps<D>& simulation, double end) {
  while (simulation.time() < end) simulation.step(end);
}

template <int D>
void expect_same(const RunState<D>& a, const RunState<D>& b) {
  EXPECT_EQ(a.particles.position, b.particles.position);
  EXPECT_EQ(a.particles.velocity, b.particles.velocity);
  EXPECT_EQ(a.particles.pressure, b.particles.pressure);
  EXPECT_EQ(a.particles.density, b.particles.density);
  EXPECT_EQ(a.particles.surface, b.particles.surface);
  EXPECT_EQ(a.particles.near_surface, b.particles.near_surface);
  EXPECT_EQ(a.particles.wet, b.particles.wet);
  EXPECT_EQ(a.particles.id, b.particles.id);
  EXPECT_EQ(a.particles.listed_position, b.particles.listed_position);
  EXPECT_EQ(a.particles.time, b.particles.time);
  EXPECT_EQ(a.sensors.readings.time, b.sensors.readings.time);
  EXPECT_EQ(a.sensors.readings.values, b.sensors.readings.values);
  EXPECT_EQ(a.totals.steps, b.totals.steps);
  EXPECT_EQ(a.totals.iterations, b.totals.iterations);
  EXPECT_EQ(a.totals.list_builds, b.totals.list_builds);
  EXPECT_EQ(a.totals.least_distance, b.totals.least_distance);
  EXPECT_EQ(a.totals.spilled, b.totals.spilled);
  EXPECT_EQ(a.fastest, b.fastest);
  EXPECT_EQ(a.short_steps, b.short_steps);
}

/// Steps half-way, goes on from a copy of the state in a new simulation, and expects the bytes of a run in one piece.
/// Half-way lies between two samples, and between two makings of the neighbour list.
template <int D>
void expect_resumes(const Parameters& p) {
  Mps<D> whole(p, interval), first(p, interval), second(p, interval);
  step_to(whole, 0.11);
  step_to(whole, 0.3);
  step_to(first, 0.11);
  second.resume(first.state());
  step_to(second, 0.3);
  EXPECT_GT(whole.state().totals.list_builds, first.state().totals.list_builds) << "or the list is not tested";
  expect_same(whole.state(), second.state());
  EXPECT_EQ(whole.frame(7)->number_density, second.frame(7)->number_density);
}

TEST(RunState, ResumesASurgingTankWithTheSameBytes) { expect_resumes<2>(test::surging(2)); }

TEST(RunState, ResumesABoxWithTheSameBytes) { expect_resumes<3>(test::surging(3)); }

TEST(RunState, ResumesThePapersScheme) {
  Parameters p = test::surging(2);
  apply_preset(p, Preset::paper);
  expect_resumes<2>(p);
}

TEST(RunState, ResumesCollisionsBetweenThePapersSteps) {
  Parameters p = test::surging(2);
  apply_preset(p, Preset::paper);
  p.method.separation = SeparationModel::collide;
  expect_resumes<2>(p);
}

TEST(RunState, ResumesEveryPressureSolver) {
  for (const auto& [solver, name, help] : ChoiceTable<SolverName>::rows) {
    SCOPED_TRACE(name);
    Parameters p = test::surging(2);
    p.pressure.solver = solver;
    expect_resumes<2>(p);
  }
}

TEST(RunState, ResumesWallsThatHaveUnknownsOfTheMixedSource) {
  Parameters p = test::surging(2);
  p.method.wall_model = WallModel::particles;
  p.method.source = SourceTerm::mixed;
  expect_resumes<2>(p);
}

TEST(RunState, ResumesARunThatSpills) {
  Parameters p = test::surging(2);
  p.tank = {.length = 0.1, .height = 0.05, .width = 0, .closed = false};
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.05, 3}};
  expect_resumes<2>(p);
}

TEST(RunState, HoldsTheFrameOfItsMoment) {
  Mps<2> first(test::surging(2), interval), second(test::surging(2), interval);
  step_to(first, 0.1);
  second.resume(first.state());
  const FramePtr a = first.frame(1), b = second.frame(1);
  EXPECT_EQ(a->number_density, b->number_density);
  EXPECT_EQ(a->free_surface, b->free_surface);
  EXPECT_EQ(a->readings.values, b->readings.values);
  EXPECT_FALSE(a->readings.values.empty());
}

}  // namespace
}  // namespace seiche::solver
