#include "solver/tank/wall_wetness.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::StillTank;

template <class T>
struct Wetness : ::testing::Test {};
TYPED_TEST_SUITE(Wetness, test::Dimensions);

TYPED_TEST(Wetness, OfStillWaterEndsAtItsTopmostLayer) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  tank.wet_walls();
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    const double y = tank.s.position[i][1];
    const Vec<D> outside =
        tank.s.position[i] - tank.s.position[i].cwiseMax(0).cwiseMin(make_shape<D>(tank.p)->bounds().high);
    if (outside.norm() > tank.w.support) continue;  // no liquid comes near it
    const double expected = tank.s.kind[i] == Kind::fluid || y < tank.p.fluid.depth ? 1 : 0;
    // Where two walls meet beside the surface a particle's share of liquid is another: by less than a hundredth.
    EXPECT_NEAR(tank.s.wet[i], expected, D == 3 ? 0.01 : 1e-12) << tank.s.position[i].transpose() / l0;
  }
}

TYPED_TEST(Wetness, IsPartialAtAContactLineThatSinks) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  // The topmost layer sinks by 0.5 l0: what is beside it is drying, what was wet below it stays wet.
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    if (tank.s.kind[i] == Kind::fluid && tank.s.position[i][1] > tank.p.fluid.depth - l0)
      tank.s.position[i][1] -= 0.5 * l0;
  tank.list = test::listed(tank.s, tank.w.support, 0.3 * l0);
  tank.wet_walls();
  int drying = 0;
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    const auto& r = tank.s.position[i];
    const bool side = r[0] < 0 && r[1] > 0 && (D == 2 || (r[D - 1] > 0.03 && r[D - 1] < 0.09));
    if (!side || tank.s.kind[i] != Kind::wall) continue;
    if (r[1] < tank.p.fluid.depth - l0) {
      EXPECT_EQ(tank.s.wet[i], 1);
    }
    if (std::abs(r[1] - tank.p.fluid.depth + 0.5 * l0) < 0.1 * l0) {
      EXPECT_GT(tank.s.wet[i], 0.5);
      EXPECT_LT(tank.s.wet[i], 0.95);
      ++drying;
    }
  }
  EXPECT_EQ(drying, D == 2 ? 1 : 6);
}

// Under a wall that leans over it by 30 degrees liquid fills 120 degrees below its level; beside an upright one, 90.
TYPED_TEST(Wetness, UnderALeaningWallTakesAWiderAngleOfLiquid) {
  constexpr int D = TypeParam::D;
  StillTank<D> upright, leaning;
  const double angle = std::numbers::pi / 6;
  for (StillTank<D>* tank : {&upright, &leaning}) {
    for (std::size_t i = 0; i < tank->s.size(); ++i)
      if (tank->s.kind[i] == Kind::fluid && tank->s.position[i][1] > tank->p.fluid.depth - l0)
        tank->s.position[i][1] -= 0.5 * l0;
    tank->list = test::listed(tank->s, tank->w.support, 0.3 * l0);
  }
  WallWetness<D> wetness(upright.w, l0);
  for (StillTank<D>* tank : {&upright, &leaning}) {
    const Vec<D> up = tank == &upright ? Vec<D>(Vec<D>::Unit(1))
                                       : Vec<D>(std::cos(angle) * Vec<D>::Unit(1) - std::sin(angle) * Vec<D>::Unit(0));
    wetness.relist(tank->list, tank->s);
    wetness(tank->pairs(), tank->ref.n0, up, tank->s);
  }
  int drying = 0;
  for (std::size_t i = 0; i < upright.s.size(); ++i) {
    const double wet = upright.s.wet[i];
    if (upright.s.kind[i] != Kind::wall || upright.s.normal[i][0] != -1 || wet <= 0 || wet >= 1) continue;
    // s = above + wet (level - above), and both thresholds are 4/3 of what they were.
    const double above = wetness.above(), level = wetness.level(), s = above + wet * (level - above);
    EXPECT_NEAR(leaning.s.wet[i], std::max(0.0, (s - 4.0 / 3 * above) / (4.0 / 3 * (level - above))), 1e-9);
    ++drying;
  }
  EXPECT_GT(drying, 0);
}

TYPED_TEST(Wetness, LetsTheContactLineBeSeenAsFreeSurface) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  tank.wet_walls();
  tank.find_surface();
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    if (tank.s.kind[i] != Kind::fluid) continue;
    EXPECT_EQ(tank.s.surface[i], tank.s.position[i][1] > tank.p.fluid.depth - l0)
        << tank.s.position[i].transpose() / l0;
    // Beside a wall as far from it: the flat surface's own density, but for the hundredth above.
    if (tank.s.surface[i]) {
      EXPECT_NEAR(tank.n[i], surface_depth<D>(tank.w, l0).topmost, 1e-3 * tank.n[i]);
    }
  }
}

}  // namespace
}  // namespace seiche::solver
