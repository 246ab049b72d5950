#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/make_simulation.hpp"
#include "solver/preset.hpp"
#include "tests/unit/solver/surging.hpp"

namespace seiche {
namespace {

using test::surging;

struct SimulationIn : ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimension, SimulationIn, ::testing::Values(2, 3));

TEST_P(SimulationIn, StartsFromTheWholeTank) {
  const Parameters p = surging(GetParam());
  const auto simulation = make_simulation(p, 0.001);
  const FramePtr frame = simulation->frame(0);
  const Statistics& totals = simulation->statistics();
  EXPECT_EQ(simulation->time(), 0);
  EXPECT_EQ(totals.fluid_particles, GetParam() == 3 ? 250 : 50);
  EXPECT_EQ(totals.fluid_particles + totals.wall_particles + totals.dummy_particles, long(frame->size()));
  EXPECT_EQ(frame->time, 0);
  EXPECT_EQ(frame->readings.time, std::vector<double>{0});
  EXPECT_EQ(frame->readings.values.size(), sensor_columns(p).size());
  for (std::size_t k = 0; k < frame->size(); ++k) EXPECT_EQ(frame->id[k], k) << "in id order";
}

TEST_P(SimulationIn, StepsLandExactlyOnUntil) {
  for (const Preset preset : {Preset::paper, Preset::stabilised}) {
    Parameters p = surging(GetParam());
    apply_preset(p, preset);
    const auto simulation = make_simulation(p, 0.001);
    for (double until : {0.01, 0.0137, 0.02}) {
      double last = simulation->time();
      while (simulation->time() < until) {
        simulation->step(until);
        ASSERT_GT(simulation->time(), last);
        last = simulation->time();
      }
      EXPECT_EQ(simulation->time(), until) << name(preset);
    }
    const FramePtr frame = simulation->frame(3);
    EXPECT_EQ(frame->time, 0.02);
    EXPECT_EQ(frame->index, 3);
    EXPECT_EQ(frame->step, simulation->statistics().steps);
    EXPECT_EQ(frame->readings.time.size(), 21u);
    EXPECT_LE(simulation->statistics().longest_step, 0.01);
    EXPECT_GT(simulation->statistics().shortest_step, 0);
  }
}

/// A tank that heaves upwards at 9.81 m/s^2 in free space is one at rest under gravity.
TEST_P(SimulationIn, WithoutGravityTheTanksAccelerationPullsAsGravityDoes) {
  Parameters still = surging(GetParam());
  still.motion = {};
  still.time.end = 1;
  Parameters thrust = still;
  thrust.gravity = 0;
  thrust.motion = {.type = MotionType::file, .file = "thrust", .start = Start::smooth};
  for (int k = 0; k <= 10; ++k) {
    const double t = 0.1 * k;
    thrust.motion.series.time.push_back(t);
    thrust.motion.series[DegreeOfFreedom::heave].push_back(0.5 * 9.81 * t * t);
  }
  const auto a = make_simulation(still, 0), b = make_simulation(thrust, 0);
  while (a->time() < 0.1) a->step(0.1);
  while (b->time() < 0.1) b->step(0.1);
  EXPECT_EQ(a->statistics().steps, b->statistics().steps);
  const FramePtr fallen = a->frame(1), pushed = b->frame(1);
  for (std::size_t k = 0; k < fallen->size(); ++k)
    EXPECT_NEAR(pushed->pressure[k], fallen->pressure[k], 0.01 * 1000 * 9.81 * 0.05);
}

TEST_P(SimulationIn, WithoutAnyPullNothingMoves) {
  for (const Preset preset : {Preset::paper, Preset::stabilised}) {
    Parameters p = surging(GetParam());
    apply_preset(p, preset);
    p.gravity = 0;
    p.motion = {};
    const auto simulation = make_simulation(p, 0.001);
    const FramePtr start = simulation->frame(0);
    for (const double until : {0.1, 0.2}) simulation->step(until);
    const FramePtr end = simulation->frame(1);
    EXPECT_EQ(end->time, 0.2);
    for (std::size_t k = 0; k < start->size(); ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(end->position[k][axis], start->position[k][axis], 1e-9) << name(preset);
  }
}

TEST_P(SimulationIn, KnowsTheLeastDistanceOfTwoParticles) {
  Parameters p = surging(GetParam());
  p.motion.harmonic.amplitude = 0.05;
  const auto simulation = make_simulation(p, 0);
  double least = 1;
  while (simulation->time() < 0.05) {
    const FramePtr frame = simulation->frame(0);
    for (std::size_t i = 0; i < frame->size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (frame->kind[i] == Kind::dummy && frame->kind[j] == Kind::dummy) continue;
        double squared = 0;
        for (int a = 0; a < 3; ++a) squared += std::pow(frame->position[i][a] - frame->position[j][a], 2);
        least = std::min(least, std::sqrt(squared));
      }
    if (simulation->time() == 0) {
      EXPECT_NEAR(least, p.particles.spacing, 1e-6);
    }
    simulation->step(0.05);
  }
  EXPECT_LT(least, 0.99 * p.particles.spacing) << "else nothing moved";
  EXPECT_NEAR(simulation->statistics().least_distance, least, 1e-6 * p.particles.spacing + 1e-7);
}

TEST_P(SimulationIn, StepsOfTheScenesOwnAreAllEqual) {
  Parameters p = surging(GetParam());
  p.time.step = 2e-4;
  const auto simulation = make_simulation(p, 0);
  for (double until : {0.006, 0.02})
    while (simulation->time() < until) simulation->step(until);
  const Statistics& totals = simulation->statistics();
  EXPECT_EQ(simulation->time(), 0.02);
  EXPECT_EQ(totals.steps, 100);
  EXPECT_NEAR(totals.shortest_step, 2e-4, 1e-13);
  EXPECT_NEAR(totals.longest_step, 2e-4, 1e-13);
}

TEST_P(SimulationIn, TheSameRunGivesTheSameBytesForEveryNumberOfThreads) {
  for (const Preset preset : {Preset::paper, Preset::stabilised}) {
    Parameters p = surging(GetParam());
    apply_preset(p, preset);
    FramePtr frames[2];
    for (auto& frame : frames) {
      p.threads = 1 + 2 * static_cast<int>(&frame - frames);
      const auto simulation = make_simulation(p, 0.001);
      while (simulation->time() < 0.05) simulation->step(0.05);
      frame = simulation->frame(1);
    }
    EXPECT_EQ(frames[0]->position, frames[1]->position) << name(preset);
    EXPECT_EQ(frames[0]->velocity, frames[1]->velocity) << name(preset);
    EXPECT_EQ(frames[0]->pressure, frames[1]->pressure) << name(preset);
    EXPECT_EQ(frames[0]->number_density, frames[1]->number_density) << name(preset);
    EXPECT_EQ(frames[0]->free_surface, frames[1]->free_surface) << name(preset);
    EXPECT_EQ(frames[0]->id, frames[1]->id) << name(preset);
    EXPECT_EQ(frames[0]->readings.values, frames[1]->readings.values) << name(preset);
    const auto moved = make_simulation(p, 0)->frame(0);
    EXPECT_NE(frames[0]->position, moved->position) << "the water moves at all";
  }
}

TEST_P(SimulationIn, WallsStandStillInTheTanksFrame) {
  const auto simulation = make_simulation(surging(GetParam()), 0);
  const FramePtr before = simulation->frame(0);
  while (simulation->time() < 0.05) simulation->step(0.05);
  const FramePtr after = simulation->frame(1);
  EXPECT_NEAR(after->pose.displacement[0], 0.01 * std::sin(2 * std::numbers::pi * 2 * 0.05), 1e-15);
  for (std::size_t k = 0; k < before->size(); ++k) {
    if (before->kind[k] == Kind::fluid) continue;
    EXPECT_EQ(after->position[k], before->position[k]);
    EXPECT_EQ(after->velocity[k], Float3{});
  }
}

TEST_P(SimulationIn, TheImpulsiveStartOfThePaperIsTheTanksVelocity) {
  Parameters p = surging(GetParam());
  apply_preset(p, Preset::paper);
  const float speed = static_cast<float>(0.01 * 2 * std::numbers::pi * 2);
  for (const bool impulsive : {true, false}) {
    p.motion.start = impulsive ? Start::impulsive : Start::smooth;
    const FramePtr frame = make_simulation(p, 0)->frame(0);
    for (std::size_t k = 0; k < frame->size(); ++k) {
      const bool moves = impulsive && frame->kind[k] == Kind::fluid;
      EXPECT_EQ(frame->velocity[k], (Float3{moves ? -speed : 0.0f, 0, 0}));
    }
  }
}

TEST_P(SimulationIn, TheImpulsiveStartOfARollTurnsAboutThePivot) {
  Parameters p = surging(GetParam());
  apply_preset(p, Preset::paper);
  p.motion = {
      .type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 3, 2}, .pivot_x = 0.03, .pivot_y = -0.02};
  const auto simulation = make_simulation(p, 0);
  const FramePtr frame = simulation->frame(0);
  const double rate = 3 * std::numbers::pi / 180 * 2 * std::numbers::pi * 2;
  EXPECT_NEAR(frame->pose.omega[2], rate, 1e-12);
  for (std::size_t k = 0; k < frame->size(); ++k) {
    if (frame->kind[k] != Kind::fluid) continue;
    EXPECT_NEAR(frame->velocity[k][0], rate * (frame->position[k][1] + 0.02), 1e-6);
    EXPECT_NEAR(frame->velocity[k][1], -rate * (frame->position[k][0] - 0.03), 1e-6);
    EXPECT_EQ(frame->velocity[k][2], 0);
  }
}

}  // namespace
}  // namespace seiche
