#include "apps/validate/surface.hpp"

#include <gtest/gtest.h>

#include "solver/simulation.hpp"

namespace seiche::validate {
namespace {

TEST(Surface, OfStillWaterIsItsDepthEverywhere) {
  Parameters p;
  p.particles.spacing = 0.01;
  RunInfo run;
  run.tank = {0.6, 0.4, 0};
  run.spacing = 0.01;
  const FramePtr frame = make_simulation(p, 0)->frame(0);
  const std::vector<double> x = stations(0.6, 60);
  EXPECT_NEAR(x.front(), 0.005, 1e-12);
  EXPECT_NEAR(x.back(), 0.595, 1e-12);
  for (const double height : surface_heights(*frame, run, x)) EXPECT_NEAR(height, 0.2, 2e-4);
}

TEST(Front, IsThatOfTheWaterNotOfDrops) {
  Frame frame;
  const auto add = [&](float x, float y, Kind kind) {
    frame.position.push_back({x, y, 0});
    frame.kind.push_back(kind);
  };
  for (int i = 0; i < 5; ++i) {
    add(0.01F * i + 0.005F, 0.005F, Kind::fluid);
    add(0.01F * i + 0.005F, 0.015F, Kind::fluid);
  }
  EXPECT_NEAR(front(frame, 0.01), 0.05, 1e-7);
  add(0.1F, 0.005F, Kind::fluid);  // a pair of drops
  add(0.11F, 0.005F, Kind::fluid);
  add(0.6F, 0.005F, Kind::wall);
  EXPECT_NEAR(front(frame, 0.01), 0.05, 1e-7);
}

}  // namespace
}  // namespace seiche::validate
