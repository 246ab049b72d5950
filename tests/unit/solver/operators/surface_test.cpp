#include <gtest/gtest.h>

#include "solver/operators/density.hpp"
#include "solver/operators/kernels.hpp"
#include "solver/parameters.hpp"
#include "tests/unit/solver/cloud.hpp"

// The free surface of a block of 9 particles along each axis with nothing around it.
namespace seiche::solver {
namespace {

using test::l0;

template <int D>
struct Block {
  State<D> s;
  KF3 w;
  Neighbours<D> list;
  Reference ref = lattice_reference<D>(w, l0);
  Scalars n = Scalars(s.size());
  Scalars count = Scalars(s.size());

  explicit Block(double radius, double spacing = l0)
      : s(test::block<D>(9, spacing)), w{radius * l0}, list(test::listed(s, w.support)) {
    number_density(test::measured(w, list, s), s, n, count);
  }

  void mark(double beta, double share) { mark_free_surface(ref, beta, share, n, count, s.kind, s.surface); }

  /// Layers between a particle and the outside, along the axis where there are fewest (0: outermost) and next fewest.
  std::pair<int, int> depth(int i) const {
    std::vector<int> layers;
    for (int a = 0; a < D; ++a) layers.push_back(4 - static_cast<int>(std::lround(std::abs(s.position[i][a]) / l0)));
    std::sort(layers.begin(), layers.end());
    return {layers[0], layers[1]};
  }

  template <class F>
  void expect_flags(F at_surface) const {
    for (int i = 0; i < static_cast<int>(s.size()); ++i)
      EXPECT_EQ(bool(s.surface[i]), at_surface(i)) << s.position[i].transpose() / l0;
  }
};

template <class T>
struct Surface : ::testing::Test {};
TYPED_TEST_SUITE(Surface, test::Dimensions);

TYPED_TEST(Surface, OfABlockIsItsOuterLayer) {
  Block<TypeParam::D> b(2.1);
  b.mark(0.97, 0);
  b.expect_flags([&](int i) { return b.depth(i).first == 0; });
}

TYPED_TEST(Surface, ByDensityAndCountIsTheOuterLayer) {
  Block<TypeParam::D> b(2.1);
  b.mark(0.97, 0.85);
  b.expect_flags([&](int i) { return b.depth(i).first == 0; });
}

TYPED_TEST(Surface, OfThePresetIsTheOuterLayerAlsoOfADisorderedBlock) {
  constexpr int D = TypeParam::D;
  const Parameters::Method m;
  for (const double disorder : {0.0, 0.1 * l0}) {
    Block<D> b(m.radius_density);
    const State<D> lattice = b.s;
    std::mt19937_64 random(1);
    for (Vec<D>& r : b.s.position) r += test::random_vec<D>(random, -disorder, disorder);
    number_density(test::measured(b.w, b.list, b.s), b.s, b.n, b.count);
    b.mark(m.surface_beta, count_share);
    b.s.position = lattice.position;
    b.expect_flags([&](int i) { return b.depth(i).first == 0; });
  }
}

TEST(Surface2D, WithALongReachIsTheOuterLayerAndTheCornersBelowIt) {
  // r_e = 2.6: a particle of the second layer lacks 3 of 20 neighbours and 2 % of n0; in a corner twice as much.
  Block<2> b(2.6);
  b.mark(0.97, 0.85);
  b.expect_flags([&](int i) { return b.depth(i).first == 0 || b.depth(i) == std::pair(1, 1); });
}

TEST(Surface2D, BetaSaysHowMuchMayLack) {
  Block<2> b(2.6);
  b.mark(0.99, 0);
  b.expect_flags([&](int i) { return b.depth(i).first <= 1; });
  b.mark(0.7, 0);  // half the neighbours are there in a flat surface but for its own layer: n/n0 = 0.66
  b.expect_flags([&](int i) { return b.depth(i).first == 0; });
  b.mark(0.5, 0);
  b.expect_flags([&](int i) { return b.depth(i) == std::pair(0, 0); });
}

TYPED_TEST(Surface, WhereNeighboursAreAllThereButFarNeedsTheWeighingOnly) {
  // 4 % wider than the lattice of n0: n falls under 0.97 n0 throughout, and nobody leaves the support.
  Block<TypeParam::D> b(2.6, 1.04 * l0);
  b.mark(0.97, 0);
  EXPECT_TRUE(b.s.surface[test::nearest<TypeParam::D>(b.s, Vec<TypeParam::D>::Zero())]);
  b.mark(0.97, 0.85);
  EXPECT_FALSE(b.s.surface[test::nearest<TypeParam::D>(b.s, Vec<TypeParam::D>::Zero())]);
}

TYPED_TEST(Surface, MayBeAWallButNeverADummy) {
  Block<TypeParam::D> b(2.1);
  for (std::size_t i = 0; i < b.s.size(); ++i) b.s.kind[i] = i % 2 ? Kind::wall : Kind::dummy;
  b.mark(0.97, 0);
  b.expect_flags([&](int i) { return b.depth(i).first == 0 && b.s.kind[i] == Kind::wall; });
}

TYPED_TEST(Surface, NearItIsWhatReachesAFlag) {
  constexpr int D = TypeParam::D;
  Block<D> b(2.6);
  std::fill(b.s.surface.begin(), b.s.surface.end(), 0);
  const int flagged = test::nearest<D>(b.s, Vec<D>::Zero());
  b.s.surface[flagged] = 1;
  std::vector<std::uint8_t> near(b.s.size(), 7);
  mark_near_surface(test::measured(KF3{2.1 * l0}, b.list, b.s), b.s, near);
  for (std::size_t i = 0; i < b.s.size(); ++i) EXPECT_EQ(near[i], b.s.position[i].norm() < 2.1 * l0);
}

}  // namespace
}  // namespace seiche::solver
