#include "solver/tank/level.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;

TEST(VolumeBelow, IsExactInABoxOpenOrClosed) {
  for (const bool closed : {true, false}) {
    Parameters p = test::small_tank<2>();
    p.tank.closed = closed;
    EXPECT_NEAR(volume_below(wall_surface(p), 0.07), 0.2 * 0.07, 1e-15);
    EXPECT_NEAR(volume_of(wall_surface(p)), 0.2 * 0.15, 1e-15);
    p.tank.width = 0.12;
    EXPECT_NEAR(volume_below(wall_surface(p), 0.07), 0.2 * 0.07 * 0.12, 1e-16);
    EXPECT_NEAR(area_of(wall_surface(p)), 2 * 0.15 * 0.32 + (closed ? 2 : 1) * 0.2 * 0.12, 1e-15);
  }
}

TEST(VolumeBelow, IsThatOfACapOfASphere) {
  const SurfaceMesh wall = sphere(0.25).surface();
  for (const double h : {0.05, 0.25, 0.4}) {
    const double cap = pi * h * h * (0.25 - h / 3);
    EXPECT_NEAR(volume_below(wall, h), cap, 3e-4 * cap) << h;
  }
  EXPECT_EQ(volume_below(wall, -0.1), 0);
  EXPECT_NEAR(area_of(wall), 4 * pi * 0.25 * 0.25, 2e-4);
}

TEST(VolumeBelow, LeavesOutAHole) {
  // A ring of 0.1 < r < 0.2, 0.3 high.
  const SurfaceMesh wall = revolve({{0, 0.1}, {0.3, 0.1}, {0.3, 0.2}, {0, 0.2}, {0, 0.1}}).surface();
  EXPECT_NEAR(volume_below(wall, 0.2), pi * 0.03 * 0.2, 2e-4 * pi * 0.03 * 0.2);
}

TEST(LevelHolding, IsTheLevelBelowWhichThatVolumeLies) {
  const SurfaceMesh wall = prism({{0, 1}, {1, 1}, {1, 3}}, 0.5).surface();  // the area below y is 1 - (3 - y)^2/4
  for (const double level : {1.3, 2.0, 2.9}) {
    const double volume = 0.5 * (1 - (3 - level) * (3 - level) / 4);
    EXPECT_NEAR(level_holding(wall, volume), level, 1e-11);
  }
  EXPECT_EQ(level_holding(wall, 7), 3);
}

}  // namespace
}  // namespace seiche::solver
