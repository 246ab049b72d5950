#include <gtest/gtest.h>

#include "tests/physics/runs.hpp"

namespace seiche::physics {
namespace {

// First crests at the walls by fully nonlinear potential theory for this tank: 7.9 mm at the right wall at 0.54 s,
// 17.1 mm at the left at 1.05 s. A surface made of particles is known to a fifth of their spacing: 1 mm at 5 mm; a
// crest's time, where it is so flat, to 0.05 s.
TEST(Sloshing, FirstCrestsAreThoseOfPotentialTheory) {
  const Parameters p = pan2008("stabilised", 0.005);
  const auto simulation = make_simulation(p, 0.001);
  struct Crest {
    std::size_t column;
    double from, to, height = -1, time = 0;
  };
  Crest right{2, 0.4, 0.7}, left{1, 0.9, 1.2};
  run(*simulation, 0.1, 1.2, [&](const Frame& frame) {
    for (std::size_t k = 0; k < frame.readings.time.size(); ++k)
      for (Crest* crest : {&left, &right}) {
        const double t = frame.readings.time[k], eta = frame.readings.values[3 * k + crest->column];
        if (t >= crest->from && t <= crest->to && eta > crest->height) crest->height = eta, crest->time = t;
      }
  });
  EXPECT_NEAR(right.height, 0.0079, 0.001);
  EXPECT_NEAR(right.time, 0.54, 0.05);
  EXPECT_NEAR(left.height, 0.0171, 0.001);
  EXPECT_NEAR(left.time, 1.05, 0.05);
  EXPECT_EQ(simulation->statistics().leaked, 0);
}

}  // namespace
}  // namespace seiche::physics
