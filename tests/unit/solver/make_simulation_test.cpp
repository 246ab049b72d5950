#include "solver/make_simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/unit/solver/surging.hpp"

namespace seiche {
namespace {

using test::surging;

TEST(Simulation, EndsWhereTheSolverDoesNotConverge) {
  Parameters p = surging(2);
  p.pressure.max_iterations = 1;
  p.pressure.tolerance = 1e-12;
  try {
    const auto simulation = make_simulation(p, 0);
    while (simulation->time() < 0.05) simulation->step(0.05);
    FAIL() << "nothing was thrown";
  } catch (const RunFailure& failure) {
    for (const char* word : {"t = ", "step ", "'amg'", "1 iterations", "1e-12"})
      EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << word << " in: " << failure.what();
  }
}

TEST(Simulation, OfAnOpenTankTakesOutAndCountsWhatSpills) {
  Parameters p = surging(2);
  p.tank = {.length = 0.1, .height = 0.05, .width = 0, .closed = false};
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.05, 3}};
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
  p.fluid.depth = 0.255;
  EXPECT_THROW(make_simulation(p, 0), BadParameters);
}

TEST(MakeSimulation, TakesEveryKernelAndSolver) {
  for (const char* kernel : {"KF1", "KF2", "KF3", "KF4", "KF5"})
    for (const auto& [solver, name, help] : ChoiceTable<SolverName>::rows) {
      Parameters p = surging(2);
      p.method.kernel = kernel;
      p.pressure.solver = solver;
      const auto simulation = make_simulation(p, 0);
      simulation->step(1e-3);
      EXPECT_EQ(simulation->statistics().steps, 1) << kernel << ' ' << name;
      EXPECT_GT(simulation->statistics().iterations, 0) << kernel << ' ' << name;
    }
}

TEST(MotionExtent, IsTheAmplitudeOfASurge) {
  Parameters p = surging(2);
  p.motion.harmonic.amplitude = -0.02;
  EXPECT_EQ(motion_extent(p), (Double3{0.02, 0, 0}));
  p.motion.type = MotionType::none;
  EXPECT_EQ(motion_extent(p), (Double3{0, 0, 0}));
}

}  // namespace
}  // namespace seiche
