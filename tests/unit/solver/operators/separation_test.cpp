#include "solver/operators/separation.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// Two particles 0.7 l0 apart along x that approach at 2 m/s, after separation to 0.8 l0.
template <int D>
State<D> separated(SeparationModel model) {
  Parameters p;
  p.particles.spacing = l0;
  p.method.separation = model;
  p.method.separation_distance = 0.8;
  State<D> s;
  s.add(Vec<D>::Zero(), Kind::fluid, Vec<D>::Zero());
  s.add(0.7 * l0 * Vec<D>::Unit(0), Kind::fluid, Vec<D>::Zero());
  s.velocity[1] = -2 * Vec<D>::Unit(0);
  const auto list = test::listed(s, 2 * l0);
  Separation<D> separate(p);
  struct FarWall {
    double distance = -1;
    Vec<D> normal = Vec<D>::Zero();
  };
  separate([](const Vec<D>&) { return FarWall{}; }, list, s);
  return s;
}

template <int D>
double distance(const State<D>& s) {
  return (s.position[1] - s.position[0]).norm();
}
template <int D>
double approach(const State<D>& s) {
  return (s.velocity[1] - s.velocity[0]).norm();
}

template <class T>
struct SeparationOf : ::testing::Test {};
TYPED_TEST_SUITE(SeparationOf, test::Dimensions);

TYPED_TEST(SeparationOf, TakesTheApproachOfAPair) {
  const auto s = separated<TypeParam::D>(SeparationModel::collide);
  EXPECT_DOUBLE_EQ(distance(s), 0.7 * l0);
  EXPECT_NEAR(approach(s), 0, 1e-15);
}

TYPED_TEST(SeparationOf, PartsAPair) {
  const auto s = separated<TypeParam::D>(SeparationModel::part);
  EXPECT_DOUBLE_EQ(distance(s), 0.8 * l0);
  EXPECT_EQ(approach(s), 2);
}

TYPED_TEST(SeparationOf, LeavesAPairAlone) {
  const auto s = separated<TypeParam::D>(SeparationModel::none);
  EXPECT_DOUBLE_EQ(distance(s), 0.7 * l0);
  EXPECT_EQ(approach(s), 2);
}

}  // namespace
}  // namespace seiche::solver
