#include "solver/simulation.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche {
namespace {

/// A tank of 10 x 10 cells (x 5), half full, that surges.
Parameters surging(int dimension) {
  Parameters p;
  p.particles.spacing = 0.01;
  p.tank = {0.1, 0.1, dimension == 3 ? 0.05 : 0, true};
  p.fluid.depth = 0.05;
  p.motion = {"surge", 0.01, 2, "impulsive"};
  p.threads = 2;
  return p;
}

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
  for (const char* preset : {"paper", "stabilised"}) {
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
      EXPECT_EQ(simulation->time(), until) << preset;
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

TEST_P(SimulationIn, TheSameRunGivesTheSameBytes) {
  for (const char* preset : {"paper", "stabilised"}) {
    Parameters p = surging(GetParam());
    apply_preset(p, preset);
    FramePtr frames[2];
    for (auto& frame : frames) {
      const auto simulation = make_simulation(p, 0.001);
      while (simulation->time() < 0.05) simulation->step(0.05);
      frame = simulation->frame(1);
    }
    EXPECT_EQ(frames[0]->position, frames[1]->position) << preset;
    EXPECT_EQ(frames[0]->velocity, frames[1]->velocity) << preset;
    EXPECT_EQ(frames[0]->pressure, frames[1]->pressure) << preset;
    EXPECT_EQ(frames[0]->number_density, frames[1]->number_density) << preset;
    EXPECT_EQ(frames[0]->free_surface, frames[1]->free_surface) << preset;
    EXPECT_EQ(frames[0]->id, frames[1]->id) << preset;
    EXPECT_EQ(frames[0]->readings.values, frames[1]->readings.values) << preset;
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
  apply_preset(p, "paper");
  const float speed = static_cast<float>(0.01 * 2 * std::numbers::pi * 2);
  for (const bool impulsive : {true, false}) {
    p.motion.start = impulsive ? "impulsive" : "smooth";
    const FramePtr frame = make_simulation(p, 0)->frame(0);
    for (std::size_t k = 0; k < frame->size(); ++k) {
      const bool moves = impulsive && frame->kind[k] == Kind::fluid;
      EXPECT_EQ(frame->velocity[k], (Float3{moves ? -speed : 0.0f, 0, 0}));
    }
  }
}

TEST_P(SimulationIn, NoConvergenceEndsTheRun) {
  Parameters p = surging(GetParam());
  p.pressure.max_iterations = 1;
  p.pressure.tolerance = 1e-12;
  try {
    const auto simulation = make_simulation(p, 0);
    while (simulation->time() < 0.05) simulation->step(0.05);
    FAIL() << "nothing was thrown";
  } catch (const RunFailure& failure) {
    for (const char* word : {"t = ", "step ", "'iccg' did not converge", "1 iterations", "1e-12"})
      EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << word << " in: " << failure.what();
  }
}

TEST(Simulation, OfAnOpenTankTakesOutAndCountsWhatSpills) {
  Parameters p = surging(2);
  p.tank = {0.1, 0.05, 0, false};
  p.motion = {"surge", 0.05, 3, "impulsive"};
  const auto simulation = make_simulation(p, 0);
  const FramePtr before = simulation->frame(0);
  const Statistics& totals = simulation->statistics();
  while (totals.spilled == 0 && simulation->time() < 0.5) simulation->step(0.5);
  ASSERT_GT(totals.spilled, 0) << "a tank filled to its rim spills when it jumps";
  EXPECT_EQ(totals.leaked, 0);
  EXPECT_EQ(totals.fluid_particles, 50 - totals.spilled);
  const FramePtr after = simulation->frame(1);
  EXPECT_EQ(long(after->size()), long(before->size()) - totals.spilled);
  const std::set<std::uint32_t> left(after->id.begin(), after->id.end());
  EXPECT_EQ(left.size(), after->size()) << "every id once";
  EXPECT_TRUE(std::is_sorted(after->id.begin(), after->id.end()));
  EXPECT_EQ(std::count(after->kind.begin(), after->kind.end(), Kind::fluid), 50 - totals.spilled);
  simulation->step(simulation->time() + 1e-4);  // and the run goes on
}

TEST(MakeSimulation, RefusesUnknownNamesAndBadParameters) {
  Parameters p = surging(2);
  p.method.kernel = "KF6";
  EXPECT_THROW(make_simulation(p, 0), BadParameters);
  p = surging(3);
  p.method.kernel = "kf3";
  EXPECT_THROW(make_simulation(p, 0), BadParameters);
  p = surging(2);
  p.pressure.solver = "multigrid";
  EXPECT_THROW(make_simulation(p, 0), std::invalid_argument);
  p = surging(2);
  p.fluid.depth = 0.055;
  EXPECT_THROW(make_simulation(p, 0), BadParameters);
}

TEST(MakeSimulation, TakesEveryKernelAndSolver) {
  for (const char* kernel : {"KF1", "KF2", "KF3", "KF4", "KF5"})
    for (const char* solver : {"iccg", "sor", "cholmod"}) {
      Parameters p = surging(2);
      p.motion.type = "none";
      p.method.kernel = kernel;
      p.pressure.solver = solver;
      const auto simulation = make_simulation(p, 0);
      simulation->step(1e-3);
      EXPECT_EQ(simulation->statistics().steps, 1) << kernel << ' ' << solver;
      EXPECT_GT(simulation->statistics().iterations, 0) << kernel << ' ' << solver;
    }
}

TEST(Motion, ExtentIsTheAmplitudeOfASurge) {
  Parameters p = surging(2);
  p.motion.amplitude = -0.02;
  EXPECT_EQ(motion_extent(p), (Double3{0.02, 0, 0}));
  p.motion.type = "none";
  EXPECT_EQ(motion_extent(p), (Double3{0, 0, 0}));
}

}  // namespace
}  // namespace seiche
