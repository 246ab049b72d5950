#include "apps/validate/surface.hpp"

#include <gtest/gtest.h>

#include "solver/run_info.hpp"

namespace seiche::apps::validate {
namespace {

TEST(Stations, AreTheMiddlesOfEqualParts) {
  const std::vector<double> x = stations(0.6, 3);
  ASSERT_EQ(x.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(x[i], 0.1 + 0.2 * i, 1e-12);
}

TEST(Surface, ComesFromTheGaugesAtTheStations) {
  Recording recording;
  recording.parameters.fluid.depth = 0.2;
  recording.stations = {0.1, 0.5};
  recording.sensors[station_column(0)] = {{0, 1, 2}, {0, 0.01, 0.03}};
  recording.sensors[station_column(1)] = {{0, 1, 2}, {0, -0.02, 0.05}};
  const Series surface = profile(recording, 1.5);
  EXPECT_EQ(surface.t, recording.stations);
  EXPECT_NEAR(surface.y[0], 0.22, 1e-12);
  EXPECT_NEAR(surface.y[1], 0.215, 1e-12);
  EXPECT_NEAR(mean_height(recording, 0, 0), 0.2, 1e-12);
  EXPECT_NEAR(mean_height(recording, 1, 2), 0.2 + (0.01 + 0.03 - 0.02 + 0.05) / 4, 1e-12);
}

TEST(Bench, RunsASceneWithGaugesAtStations) {
  Bench bench(SEICHE_SOURCE_DIR "/scenes", true, 1, [] { return false; });
  const std::vector<double> x = stations(0.5, 4);
  int frames = 0;
  const Recording run = bench.run(
      "still-tank", {"particles.spacing=0.02", "time.end=0.02", "output.frame_rate=100"},
      [&](const Frame&, const RunInfo&) { ++frames; }, x);
  EXPECT_EQ(frames, 3);
  EXPECT_EQ(run.end, 0.02);
  EXPECT_EQ(run.failure, "");
  EXPECT_EQ(run.sensors.at("p_left_bottom").size(), 21u);
  EXPECT_NEAR(run.sensors.at("p_left_bottom").at(0.01), 1962, 20);
  EXPECT_EQ(run.sensors.count("eta_left") + run.sensors.count("eta_right"), 2u);
  const Series surface = profile(run, 0.02);
  EXPECT_EQ(surface.t, x);
  for (const double height : surface.y) EXPECT_NEAR(height, 0.2, 0.002);
}

TEST(Front, IsThatOfTheWaterNotOfDrops) {
  Frame frame;
  const auto add = [&](float x, float y, Kind kind) {
    frame.position.push_back({x, y, 0});
    frame.kind.push_back(kind);
  };
  for (int i = 0; i < 5; ++i) {
    add(0.01F * static_cast<float>(i) + 0.005F, 0.005F, Kind::fluid);
    add(0.01F * static_cast<float>(i) + 0.005F, 0.015F, Kind::fluid);
  }
  EXPECT_NEAR(front(frame, 0.01), 0.05, 1e-7);
  add(0.1F, 0.005F, Kind::fluid);  // a pair of drops
  add(0.11F, 0.005F, Kind::fluid);
  add(0.6F, 0.005F, Kind::wall);
  EXPECT_NEAR(front(frame, 0.01), 0.05, 1e-7);
}

}  // namespace
}  // namespace seiche::apps::validate
