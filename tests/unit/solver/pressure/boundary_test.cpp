#include "solver/pressure/boundary.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::StillTank;

template <class T>
struct Boundary : ::testing::Test {};
TYPED_TEST_SUITE(Boundary, test::Dimensions);

TYPED_TEST(Boundary, RiseAcrossAWallIsAlongItsNormalOnly) {
  constexpr int D = TypeParam::D;
  const Vec<D> slope = test::slanted<D>(), r = 2 * test::slanted<D>();
  EXPECT_DOUBLE_EQ(rise_across<D>(-Vec<D>::Unit(1), slope, r), 2 * 4);
  EXPECT_DOUBLE_EQ(rise_across<D>(Vec<D>::Unit(0), slope, r), 1 * 2);
  EXPECT_DOUBLE_EQ(rise_across<D>(Vec<D>::Unit(0), slope, Vec<D>(3 * Vec<D>::Unit(1))), 0);
}

TYPED_TEST(Boundary, ThePapersUnknownsAreFluidAndWallBelowTheSurface) {
  StillTank<TypeParam::D> tank;
  const auto paper = tank.paper();
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    EXPECT_EQ(paper.unknown(i), tank.s.kind[i] != Kind::dummy && !tank.s.surface[i]);
}

TYPED_TEST(Boundary, UnknownsBetweenGhostsAreFluidBelowTheSurface) {
  StillTank<TypeParam::D> tank;
  const auto ghost = tank.ghost();
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    EXPECT_EQ(ghost.unknown(i), tank.s.kind[i] == Kind::fluid && !tank.s.surface[i]);
}

TYPED_TEST(Boundary, AirBelongsToTheSecondLayerOnly) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  const auto ghost = tank.ghost();
  Vec<D> r = Vec<D>::Constant(0.065);
  r[1] = 0.085;  // the second layer lacks what lies 2 l0 above: 3 neighbours in 2-D, 9 in 3-D
  const double above = D == 2 ? tank.w(2 * l0) + 2 * tank.w(std::sqrt(5) * l0)
                              : tank.w(2 * l0) + 4 * tank.w(std::sqrt(5) * l0) + 4 * tank.w(std::sqrt(6) * l0);
  EXPECT_NEAR(ghost.diagonal(test::nearest<D>(tank.s, r)), 4. / 3 * above, 1e-12);
  r[1] = 0.075;
  EXPECT_NEAR(ghost.diagonal(test::nearest<D>(tank.s, r)), 0, 1e-12);
  r[1] = 0.035;
  EXPECT_EQ(ghost.diagonal(test::nearest<D>(tank.s, r)), 0);
}

TYPED_TEST(Boundary, WallsOfStillWaterReadItsPressure) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  extend_to_walls(tank.pairs(), tank.everywhere(), tank.s);
  for (int beside : {0, 1}) {
    Vec<D> r = Vec<D>::Constant(0.065);
    r[1 - beside] = -0.5 * l0;  // the floor, then the left wall
    const int wall = test::nearest<D>(tank.s, r);
    ASSERT_EQ(tank.s.kind[wall], Kind::wall);
    EXPECT_NEAR(tank.s.pressure[wall], tank.hydrostatic(r), 1e-8);
  }
  Vec<D> dry = Vec<D>::Constant(0.065);
  dry[1] = tank.p.tank.height + 0.5 * l0;
  EXPECT_EQ(tank.s.pressure[test::nearest<D>(tank.s, dry)], 0) << "no fluid there";
}

}  // namespace
}  // namespace seiche::solver
