#include "solver/operators/surface_detection.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// A block of 9^D particles, `spacing` apart, and what is found in it with a kernel of 2.6 l0.
template <int D>
State<D> searched(SurfaceTest test, double spacing = l0, double beta = Parameters::Method{}.surface_beta) {
  Parameters p;
  p.particles.spacing = l0;
  p.method.surface = test;
  p.method.surface_beta = beta;
  State<D> s = test::block<D>(9, spacing);
  Range<D> range(p, p.method.radius_density);
  range.measure(test::listed(s, 2.6 * l0), s);
  SurfaceDetection<D> detect(p.method);
  detect(range, s);
  const int middle = test::nearest<D>(s, Vec<D>::Zero());
  if (spacing == l0) {
    EXPECT_NEAR(s.density[middle], range.ref.n0, 1e-12 * range.ref.n0);
  }
  return s;
}

template <class T>
struct SurfaceDetectionOf : ::testing::Test {};
TYPED_TEST_SUITE(SurfaceDetectionOf, test::Dimensions);

TYPED_TEST(SurfaceDetectionOf, FindsTheOutermostLayerOfABlockAndItsNeighbours) {
  constexpr int D = TypeParam::D;
  const State<D> s = searched<D>(SurfaceTest::density_and_count);
  for (int layer = 0; layer <= 4; ++layer) {
    const int i = test::nearest<D>(s, layer * l0 * Vec<D>::Unit(1));
    EXPECT_EQ(s.surface[i], layer == 4) << layer;
    EXPECT_EQ(s.near_surface[i], layer >= 2) << layer;
  }
}

TYPED_TEST(SurfaceDetectionOf, TakesThinLiquidForASurfaceByDensityAlone) {
  constexpr int D = TypeParam::D;
  // All neighbours are there, a little farther away.
  const auto middle = [](const State<D>& s) { return s.surface[test::nearest<D>(s, Vec<D>::Zero())]; };
  EXPECT_EQ(middle(searched<D>(SurfaceTest::density, 1.05 * l0, 0.97)), 1);
  EXPECT_EQ(middle(searched<D>(SurfaceTest::density_and_count, 1.05 * l0, 0.97)), 0);
}

}  // namespace
}  // namespace seiche::solver
