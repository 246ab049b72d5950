#include "solver/motion/level_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/errors.hpp"
#include "solver/make_simulation.hpp"
#include "solver/tank/level_axes.hpp"
#include "solver/tank/pools.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A motion whose samples are f(t), 0 to 1 s.
template <class F>
Parameters::Motion moved(DegreeOfFreedom of, F f) {
  Parameters::Motion m{.type = MotionType::file, .file = "samples", .start = Start::level};
  for (int k = 0; k <= 20; ++k) {
    m.series.time.push_back(0.05 * k);
    m.series[of].push_back(f(0.05 * k));
  }
  return m;
}

Parameters tilted(double degrees) {
  Parameters p = small_tank<2>();
  p.motion = moved(DegreeOfFreedom::roll, [&](double) { return degrees; });
  p.time.end = 0.5;
  return p;
}

/// A cylinder of 12 spacings radius that turns steadily such that its paraboloid is 4 spacings high.
Parameters turning() {
  Parameters p;
  p.particles.spacing = 0.01;
  p.tank.shape = TankShape::cylinder;
  p.tank.radius = 0.12;
  p.tank.length = 0.24;
  p.fluid.depth = 0.12;
  const double spin = std::sqrt(p.gravity.size() / 0.18);
  p.motion = moved(DegreeOfFreedom::yaw, [&](double t) { return spin / degree * t; });
  p.time.end = 0.5;
  return p;
}

/// The height above the floor of the highest fluid particle within a spacing of x.
template <int D>
double top_about(const State<D>& s, double x, double l0) {
  double top = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid && std::abs(s.position[i][0] - x) < l0 &&
        (D == 2 || std::abs(s.position[i][D - 1]) < l0))
      top = std::max(top, s.position[i][1]);
  return top;
}

TEST(EquilibriumAtStart, IsGravityAloneUnlessItIsLevel) {
  Parameters p = tilted(10);
  p.motion.start = Start::smooth;
  EXPECT_EQ(equilibrium_at_start(p), RelativeEquilibrium{p.gravity});
}

TEST(EquilibriumAtStart, IsGravityAloneOfATankThatStandsUpright) {
  EXPECT_EQ(equilibrium_at_start(tilted(0)), RelativeEquilibrium{Gravity()});
}

TEST(EquilibriumAtStart, TurnsGravityBackByTheTilt) {
  const Gravity g = equilibrium_at_start(tilted(10)).gravity;
  EXPECT_NEAR(g[0], -9.81 * std::sin(10 * degree), 1e-9);
  EXPECT_NEAR(g[1], -9.81 * std::cos(10 * degree), 1e-9);
}

TEST(EquilibriumAtStart, HasTheInertialForceOfASteadyAcceleration) {
  Parameters p = small_tank<2>();
  p.motion = moved(DegreeOfFreedom::surge, [](double t) { return 0.5 * 2 * t * t; });
  const RelativeEquilibrium at_rest = equilibrium_at_start(p);
  EXPECT_NEAR(at_rest.gravity[0], -2, 1e-6);
  EXPECT_EQ(at_rest.spin, 0);
}

TEST(EquilibriumAtStart, TurnsWithASteadyYaw) {
  const RelativeEquilibrium at_rest = equilibrium_at_start(turning());
  EXPECT_EQ(at_rest.gravity, Gravity());
  EXPECT_NEAR(at_rest.spin, std::sqrt(9.81 / 0.18), 1e-6);
}

TEST(LevelStart, FillsATiltedTankWithAsMuchLiquid) {
  const Parameters p = tilted(10);
  const double l0 = p.particles.spacing, area = 0.2 * 0.1;
  const State<2> s = fill_tank<2>(p, *make_shape<2>(p), equilibrium_at_start(p));
  const auto fluid = std::count(s.kind.begin(), s.kind.end(), Kind::fluid);
  EXPECT_NEAR(static_cast<double>(fluid) * l0 * l0, area, 0.5 * l0 * l0);
  // Level in the lab: rolled from x towards y, it stands deeper at the left.
  const double slope = (top_about(s, 0.04, l0) - top_about(s, 0.16, l0)) / 0.12;
  EXPECT_NEAR(slope, std::tan(10 * degree), 0.5 * l0 / 0.12);
}

TEST(LevelStart, FillsATurningTankUnderAParaboloid) {
  const Parameters p = turning();
  const double l0 = p.particles.spacing;
  const State<3> s = fill_tank<3>(p, *make_shape<3>(p), equilibrium_at_start(p));
  const auto fluid = std::count(s.kind.begin(), s.kind.end(), Kind::fluid);
  const double volume = liquid_volume(p);
  EXPECT_NEAR(static_cast<double>(fluid) * std::pow(l0, 3), volume, std::pow(l0, 3));
  for (const double r : {0.0, 0.03, 0.06, 0.09}) {
    const double level = 0.12 - 0.02 + 0.04 * std::pow(r / 0.12, 2);
    EXPECT_NEAR(top_about(s, r, 0.51 * l0) + 0.5 * l0, level, 0.6 * l0) << r;
  }
}

TEST(LevelStart, StaysAsItStarts) {
  Parameters p = tilted(10);
  const auto run = make_simulation(p, 0.05);
  while (run->time() < 0.2) run->step(0.2);
  const FramePtr frame = run->frame(1);
  double fastest = 0;
  for (std::size_t i = 0; i < frame->size(); ++i)
    if (frame->kind[i] == Kind::fluid)
      fastest = std::max<double>(fastest, std::hypot(frame->velocity[i][0], frame->velocity[i][1]));
  EXPECT_LT(fastest, 0.03 * std::sqrt(9.81 * 0.1));  // a level surface in the tank itself would fall at 0.17
}

TEST(LevelStart, IsRefusedWhereTheLiquidWouldPassTheRim) {
  Parameters p = tilted(30);
  p.tank.closed = false;
  EXPECT_THROW(check_level_start(p), BadParameters);
}

// The gas of a neck, spread along a side as the tank lies on the other.
TEST(LevelStart, IsRefusedWhereItLeavesNoGas) {
  Parameters p = tilted(90);
  p.particles.spacing = 0.01;
  p.tank.shape = TankShape::prism;
  p.tank.points = {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0.12, 0.1}, {0.12, 0.16}, {0.08, 0.16}, {0.08, 0.1}, {0, 0.1}};
  p.fluid.depth = 0.12;  // 0.04 m by 0.04 m of gas: 1.6 spacings along a side of 0.1 m
  EXPECT_NO_THROW(check_level_start(p));
  p.fluid.depth = 0.14;
  EXPECT_THROW(check_level_start(p), BadParameters);
}

TEST(LevelStart, IsRefusedToAColumnAndToAWave) {
  Parameters column = tilted(10), wave = tilted(10);
  column.fluid.column = 0.1;
  wave.fluid.wave_amplitude = 0.001;
  EXPECT_THROW(check_level_start(column), BadParameters);
  EXPECT_THROW(check_level_start(wave), BadParameters);
}

TEST(LevelStart, KeepsTheVolumeOfEachChamber) {
  Parameters p = tilted(5);
  p.tank.baffles = {{.points = {{{0.1, 0}}, {{0.1, 0.15}}}}};
  p.fluid.seeds = {{0.05, 0.02, 0, 0.05}, {0.15, 0.02, 0, 0.1}};
  const auto tank = make_shape<2>(p);
  const auto still = pools_of(p, *tank), level = pools_of(p, *tank, equilibrium_at_start(p));
  ASSERT_EQ(level.size(), 2u);
  const double l0 = p.particles.spacing;
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(level[k].volume, still[k].volume, 0.1 * l0 * l0);
}

}  // namespace
}  // namespace seiche::solver::test
