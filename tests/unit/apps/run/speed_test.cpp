#include "apps/run/speed.hpp"

#include <gtest/gtest.h>

namespace seiche::apps {
namespace {

Statistics moved(long particles, long steps) {
  Statistics statistics;
  statistics.fluid_particles = particles;
  statistics.steps = steps;
  return statistics;
}

TEST(Speed, IsFluidParticlesTimesStepsOverTheSolversTime) {
  const Times times{{{"solve", 3}, {"search", 1}}, {{"pictures", 5}}, 1, 10};
  EXPECT_EQ(particle_steps_per_second(moved(4800, 1000), times), 1.2e6);
  EXPECT_EQ(waited_share(times), 0.1);
}

TEST(Speed, OfARunWithoutAStepIsNone) {
  EXPECT_EQ(particle_steps_per_second(moved(4800, 0), {}), 0);
  EXPECT_EQ(waited_share({}), 0);
}

TEST(Speed, TextHasThreeDigitsAndTheGreatestStagesFirst) {
  const Times times{{{"assembly", 0.3}, {"density", 0.05}, {"search", 0.04}, {"solve", 0.61}}, {}, 0, 1};
  EXPECT_EQ(speed_text(moved(4800, 257), times),
            "1,230,000 particle-steps a second: solve 61 %, assembly 30 %, other 9 %");
  EXPECT_EQ(speed_text(moved(10, 9), times).substr(0, 24), "90 particle-steps a seco");
  EXPECT_EQ(speed_text(moved(1, 1), {{{"solve", 1}}, {}, 0, 1}), "1 particle-steps a second: solve 100 %");
}

TEST(Speed, OutputsSayWhatTheyTookAndWhatTheyCost) {
  EXPECT_EQ(outputs_text({{}, {{"pictures", 12.3}, {"probes", 0.02}, {"vtu", 2}}, 3, 12}),
            "pictures 12 s, vtu 2.0 s, beside the steps; held the run up for 3.0 s (25 %)");
}

}  // namespace
}  // namespace seiche::apps
