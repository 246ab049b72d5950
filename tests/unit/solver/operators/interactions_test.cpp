#include "solver/operators/interactions.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

Parameters of_radii(double density, double gradient, double laplacian) {
  Parameters p;
  p.particles.spacing = l0;
  p.method.radius_density = density;
  p.method.radius_gradient = gradient;
  p.method.radius_laplacian = laplacian;
  return p;
}

/// Those of a block of 9^D particles.
template <int D>
Interactions<D> between(const Parameters& p, State<D>& s) {
  Interactions<D> near(p, Vec<D>::Constant(-5 * l0), Vec<D>::Constant(5 * l0), 3.1);
  near.list.build(s);
  near.measure(s);
  return near;
}

template <class T>
struct InteractionsOf : ::testing::Test {};
TYPED_TEST_SUITE(InteractionsOf, test::Dimensions);

TYPED_TEST(InteractionsOf, MeasureEachRangeAsFarAsItReaches) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  const auto near = between(of_radii(1.1, 1.5, 3.1), s);
  const int middle = test::nearest<D>(s, Vec<D>::Zero());
  EXPECT_EQ((*near.density.pairs)[middle].size(), 2 * D);
  EXPECT_EQ((*near.gradient.pairs)[middle].size(), D == 2 ? 8 : 18) << "with the diagonals of a face";
  EXPECT_EQ((*near.laplacian.pairs)[middle].size(), near.laplacian.ref.count);
  EXPECT_EQ(near.density.ref.count, 2 * D);
}

TYPED_TEST(InteractionsOf, OfOneRadiusShareTheirPairs) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  const auto alike = between(of_radii(2.6, 2.6, 2.6), s);
  EXPECT_EQ(alike.gradient.pairs, alike.density.pairs);
  EXPECT_EQ(alike.laplacian.pairs, alike.density.pairs);
  const auto two = between(of_radii(2.1, 2.1, 3.1), s);
  EXPECT_EQ(two.gradient.pairs, two.density.pairs);
  EXPECT_NE(two.laplacian.pairs, two.density.pairs);
}

}  // namespace
}  // namespace seiche::solver
