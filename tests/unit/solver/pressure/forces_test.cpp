#include "solver/pressure/forces.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

/// f = -r + 2 u, whose divergence is said to be -3.
struct Spring {
  double divergence = -3;
  template <int D>
  Vec<D> operator()(const Vec<D>& r, const Vec<D>& u) const {
    return 2 * u - r;
  }
};

template <class T>
struct ForcesOn : ::testing::Test {};
TYPED_TEST_SUITE(ForcesOn, test::Dimensions);

TYPED_TEST(ForcesOn, FluidAreThoseOfItsPlaceAndVelocity) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(3);
  s.velocity[4] = test::slanted<D>();
  Forces<D> forces;
  forces.set_body(Spring{}, 800, s);
  const Vec<D> exact = 2 * test::slanted<D>() - s.position[4];
  EXPECT_EQ(forces.body[4], exact);
  EXPECT_EQ(forces.slope[4], Vec<D>(800 * exact));
  EXPECT_EQ(forces.divergence, -3);
}

}  // namespace
}  // namespace seiche::solver
