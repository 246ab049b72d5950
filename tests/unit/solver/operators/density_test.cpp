#include "solver/operators/density.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct Density : ::testing::Test {};
TYPED_TEST_SUITE(Density, test::Dimensions);

TYPED_TEST(Density, InsideALatticeIsTheReferenceForEveryKernel) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  const auto list = test::listed(s, 3.1 * l0, 0.3 * l0);
  Scalars n(s.size());
  Scalars count(s.size());
  for (double radius : {2.1, 2.6, 3.1})
    for (const Kernel& kernel : kernel_table(radius * l0))
      std::visit(
          [&](const auto& w) {
            const Reference ref = lattice_reference<D>(w, l0);
            number_density(test::measured(w, list, s), s, n, count);
            int full = 0;
            for (std::size_t i = 0; i < s.size(); ++i) {
              if (test::reach<D>(s.position[i]) > 1.1 * l0) continue;
              { EXPECT_NEAR(n[i], ref.n0, 1e-12 * ref.n0) << w.name << ' ' << radius; }
              EXPECT_EQ(count[i], ref.count) << w.name << ' ' << radius;
              ++full;
            }
            EXPECT_EQ(full, D == 2 ? 9 : 27);
          },
          kernel);
}

TYPED_TEST(Density, IsTheSumOfTheWeightsWithinTheSupport) {
  constexpr int D = TypeParam::D;
  State<D> s;
  const double x[] = {0, 0.7, -1.3, 2.05};  // the last one is in the list but beyond the support
  for (double at : x) s.add(Vec<D>::Unit(D - 1) * at, Kind::fluid, Vec<D>::Zero());
  const auto list = test::listed(s, 2, 0.1);
  const KF5 w{2};
  Scalars n(s.size());
  Scalars count(s.size());
  number_density(test::measured(w, list, s), s, n, count);
  const int i = test::nearest<D>(s, Vec<D>::Zero());
  EXPECT_EQ(list[i].size(), 3u);
  EXPECT_DOUBLE_EQ(n[i], w(0.7) + w(1.3));
  EXPECT_EQ(count[i], 2);
}

TYPED_TEST(Density, WeighsWallsByTheirVolume) {
  constexpr int D = TypeParam::D;
  State<D> s;
  s.add(Vec<D>::Zero(), Kind::fluid, Vec<D>::Zero());
  s.add(Vec<D>::Unit(0), Kind::wall, Vec<D>::Unit(0), 0.75);
  const auto list = test::listed(s, 2, 0.1);
  const KF5 w{2};
  Scalars n(2), count(2);
  number_density(test::measured(w, list, s), s, n, count);
  const int i = s.kind[0] == Kind::fluid ? 0 : 1;
  EXPECT_DOUBLE_EQ(n[i], 0.75 * w(1));
  EXPECT_DOUBLE_EQ(count[i], 0.75);
  s.wet[1 - i] = 0.3;
  number_density(test::measured(w, list, s), s, n, count);
  EXPECT_DOUBLE_EQ(n[i], 0.3 * w(1));
  EXPECT_DOUBLE_EQ(count[i], 0) << "less than half of it is wet";
}

TYPED_TEST(Density, CountsEveryKindAndLeavesDummiesAtZero) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(5);
  const int kinds = 3;
  for (std::size_t i = 0; i < s.size(); ++i) s.kind[i] = static_cast<Kind>(i % kinds);
  const KF3 w{2.1 * l0};
  const auto list = test::listed(s, w.support);
  Scalars n(s.size(), -1);
  Scalars count(s.size(), -1);
  number_density(test::measured(w, list, s), s, n, count);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const bool dummy = s.kind[i] == Kind::dummy;
    if (dummy || test::reach<D>(s.position[i]) < 0.1 * l0) {
      EXPECT_NEAR(n[i], dummy ? 0 : lattice_reference<D>(w, l0).n0, 1e-12);
    }
    if (dummy) {
      EXPECT_EQ(count[i], 0);
    }
  }
}

}  // namespace
}  // namespace seiche::solver
