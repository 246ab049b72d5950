#include <gtest/gtest.h>

#include "tests/physics/runs.hpp"

// What the paper found of its own scheme: kernels 2 and 5 can't be used, kernel 3 can. Nothing is arranged: the runs
// are those of scenes/pan2008-paper.toml at 10 mm.
namespace seiche::physics {
namespace {

double lasts_until(const std::string& kernel, double end) {
  Parameters p = pan2008(Preset::paper, 0.01);
  p.method.kernel = kernel;
  const auto simulation = make_simulation(p, 0);
  try {
    while (simulation->time() < end) simulation->step(end);
  } catch (const RunFailure& failure) {
    EXPECT_EQ(failure.failure.time, simulation->time()) << failure.what();
    EXPECT_GT(failure.failure.step, 0) << failure.what();
  }
  return simulation->time();
}

TEST(PaperScheme, Kernel2StopsBeforeTwoSeconds) { EXPECT_LT(lasts_until("KF2", 2), 2); }
TEST(PaperScheme, Kernel5StopsBeforeTwoSeconds) { EXPECT_LT(lasts_until("KF5", 2), 2); }
// Walls that cut the lattice hold, too, in a hexagon and a circle.
TEST(PaperScheme, ItsWallsHoldInAPolygonAndACircle) {
  const double side = 0.25, x = 0.5 * std::sqrt(3.0) * side;
  Parameters::Tank hexagon{.shape = TankShape::prism, .length = 0, .height = 0};
  hexagon.points = {{0, 0}, {x, 0.5 * side}, {x, 1.5 * side}, {0, 2 * side}, {-x, 1.5 * side}, {-x, 0.5 * side}};
  const Parameters::Tank circle{
      .shape = TankShape::sphere, .length = 0, .height = 0, .radius = 0.25, .section = SectionPlane{}};
  for (const Parameters::Tank& tank : {hexagon, circle}) {
    Parameters p;
    apply_preset(p, Preset::paper);
    p.tank = tank;
    p.fluid.depth = 0.25;
    p.particles.spacing = 0.0125;
    const auto simulation = make_simulation(p, 0);
    while (simulation->time() < 0.5) simulation->step(0.5);
    EXPECT_EQ(simulation->statistics().leaked, 0) << name(tank.shape);
  }
}

TEST(PaperScheme, Kernel3Lasts) { EXPECT_EQ(lasts_until("KF3", 2), 2); }

}  // namespace
}  // namespace seiche::physics
