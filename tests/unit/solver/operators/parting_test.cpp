#include <gtest/gtest.h>

#include "solver/operators/close_pairs.hpp"
#include "tests/unit/solver/cloud.hpp"

// The paper's additional modification.
namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct Parting : ::testing::Test {};
TYPED_TEST_SUITE(Parting, test::Dimensions);

/// Parts a pair at 0.2 l0 along a slanted line to 0.5 l0, and returns the state.
template <int D>
State<D> parted(Kind other, double distance) {
  State<D> s;
  const Vec<D> line = test::slanted<D>().normalized();
  s.add(Vec<D>::Constant(l0), Kind::fluid, Vec<D>::Zero());
  s.add(Vec<D>::Constant(l0) + distance * line, other, Vec<D>::Zero());
  const auto list = test::listed(s, 2 * l0);
  Vecs<D> moved(s.size());
  part_close_pairs(0.5 * l0, list, s, moved);
  if (s.id[0] == 1) s.reorder({1, 0});
  return s;
}

TYPED_TEST(Parting, TwoFluidParticlesShareTheWay) {
  constexpr int D = TypeParam::D;
  const State<D> s = parted<D>(Kind::fluid, 0.2 * l0);
  const Vec<D> line = test::slanted<D>().normalized(), first = Vec<D>::Constant(l0);
  EXPECT_LT((s.position[0] - (first - 0.15 * l0 * line)).norm(), 1e-15);
  EXPECT_LT((s.position[1] - (first + 0.35 * l0 * line)).norm(), 1e-15);
}

TYPED_TEST(Parting, AWallStaysWhereItIs) {
  constexpr int D = TypeParam::D;
  for (Kind other : {Kind::wall, Kind::dummy}) {
    const State<D> s = parted<D>(other, 0.2 * l0);
    const Vec<D> line = test::slanted<D>().normalized(), first = Vec<D>::Constant(l0);
    EXPECT_LT((s.position[0] - (first - 0.3 * l0 * line)).norm(), 1e-15);
    EXPECT_EQ(s.position[1], Vec<D>(first + 0.2 * l0 * line));
  }
}

TYPED_TEST(Parting, LeavesFurtherPairsAlone) {
  constexpr int D = TypeParam::D;
  const State<D> s = parted<D>(Kind::fluid, 0.501 * l0);
  EXPECT_EQ(s.position[0], Vec<D>(Vec<D>::Constant(l0)));
}

TYPED_TEST(Parting, KeepsTheCentreOfACloud) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(100, -l0, l0);
  const auto list = test::listed(s, 2 * l0);
  const auto centre = [&] {
    Vec<D> sum = Vec<D>::Zero();
    for (const auto& r : s.position) sum += r;
    return sum;
  };
  const Vec<D> before = centre();
  Vecs<D> moved(s.size());
  part_close_pairs(0.5 * l0, list, s, moved);
  EXPECT_LT((centre() - before).norm(), 1e-14);
  EXPECT_GT(moved[0].norm(), 0);
}

}  // namespace
}  // namespace seiche::solver
