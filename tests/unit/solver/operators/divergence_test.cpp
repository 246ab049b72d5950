#include "solver/operators/divergence.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D, class K, class F>
Scalars divergence_of(const K& w, State<D>& s, F u) {
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = u(s.position[i]);
  Scalars out(s.size(), -1);
  VelocityGradients<D> gradient(s.size());
  velocity_divergence(test::measured(w, list, s), lattice_reference<D>(w, l0).n0, s, out, gradient);
  return out;
}

/// A block whose lower part, y < 0, is a wall and a dummy layer below it, with normals out of the tank.
template <int D>
State<D> above_a_floor() {
  State<D> s = test::block<D>(7);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.position[i][1] > -0.5 * l0) continue;
    s.kind[i] = s.position[i][1] > -1.5 * l0 ? Kind::wall : Kind::dummy;
    s.normal[i] = -Vec<D>::Unit(1);
  }
  return s;
}

/// sum over the layer `down` layers below of w r_y^2/r^2, within 2.1 l0.
template <int D>
double normal_sum(const KF3& w, int down) {
  double sum = 0;
  for (int i = -2; i <= 2; ++i)
    for (int k = D == 3 ? -2 : 0; k <= (D == 3 ? 2 : 0); ++k) {
      const double r2 = i * i + down * down + k * k;
      sum += w(std::sqrt(r2) * l0) * down * down / r2;
    }
  return sum;
}

template <class T>
struct Divergence : ::testing::Test {};
TYPED_TEST_SUITE(Divergence, test::Dimensions);

TYPED_TEST(Divergence, IsExactOnLinearFieldsOfALattice) {
  constexpr int D = TypeParam::D;
  Eigen::Matrix<double, D, D> a;
  for (int k = 0; k < D * D; ++k) a(k / D, k % D) = 3 - k * k;
  for (const Kernel& kernel : kernel_table(2.6 * l0))
    std::visit(
        [&](const auto& w) {
          State<D> s = test::block<D>(7);
          const auto divergence =
              divergence_of<D>(w, s, [&](const Vec<D>& r) { return Vec<D>(a * r + Vec<D>::Ones()); });
          EXPECT_NEAR(divergence[test::nearest<D>(s, Vec<D>::Zero())], a.trace(), 1e-11) << w.name;
        },
        kernel);
}

TYPED_TEST(Divergence, IsExactOnLinearFieldsOfAnyCloudAndAtItsSurface) {
  constexpr int D = TypeParam::D;
  Eigen::Matrix<double, D, D> a;
  for (int k = 0; k < D * D; ++k) a(k / D, k % D) = 3 - k * k;
  State<D> s = test::disordered<D>(test::block<D>(9), 0.2 * l0);
  const auto divergence = divergence_of<D>(KF3{2.6 * l0}, s, [&](const Vec<D>& r) { return Vec<D>(a * r); });
  int tested = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    // But for the block's edges, where too few neighbours are left.
    int outer = 0;
    for (int k = 0; k < D; ++k) outer += std::abs(s.position[i][k]) > 3 * l0;
    if (outer > 1) continue;
    EXPECT_NEAR(divergence[i], a.trace(), 1e-10) << s.position[i].transpose() / l0;
    ++tested;
  }
  EXPECT_GE(tested, D == 2 ? 60 : 500);
}

TYPED_TEST(Divergence, ComesWithTheGradientThatLiquidAloneHasAlsoBesideAWall) {
  constexpr int D = TypeParam::D;
  const KF3 w{2.6 * l0};
  Eigen::Matrix<double, D, D> a;
  for (int k = 0; k < D * D; ++k) a(k / D, k % D) = 3 - k * k;
  State<D> s = above_a_floor<D>();
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = a * s.position[i] + Vec<D>::Ones();
  Scalars divergence(s.size());
  VelocityGradients<D> gradient(s.size());
  velocity_divergence(test::measured(w, list, s), lattice_reference<D>(w, l0).n0, s, divergence, gradient);
  for (int layer = 0; layer < 3; ++layer) {
    const int i = test::nearest<D>(s, layer * l0 * Vec<D>::Unit(1));
    EXPECT_LT((gradient[i] - a).norm(), 1e-11) << layer;
  }
}

TYPED_TEST(Divergence, DryWallsStopNothing) {
  constexpr int D = TypeParam::D;
  State<D> s = above_a_floor<D>();
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] != Kind::fluid) s.wet[i] = 0;
  const auto divergence = divergence_of<D>(KF3{2.6 * l0}, s, [](const Vec<D>&) { return Vec<D>(-Vec<D>::Unit(1)); });
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) {
      EXPECT_NEAR(divergence[i], 0, 1e-12);
    }
}

TYPED_TEST(Divergence, OfARotationIsZeroOnAnyCloud) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(200, -2 * l0, 2 * l0);
  const auto spin = [](const Vec<D>& r) { return Vec<D>(r[1] * Vec<D>::Unit(0) - r[0] * Vec<D>::Unit(1)); };
  for (double value : divergence_of<D>(KF3{2.6 * l0}, s, spin)) EXPECT_NEAR(value, 0, 1e-12);
}

TYPED_TEST(Divergence, FluidSlidesAlongAWall) {
  constexpr int D = TypeParam::D;
  State<D> s = above_a_floor<D>();
  for (double value : divergence_of<D>(KF3{2.6 * l0}, s, [](const Vec<D>&) { return Vec<D>::Unit(0); }))
    EXPECT_EQ(value, 0);
}

TYPED_TEST(Divergence, FluidThatMeetsAWallIsCompressed) {
  constexpr int D = TypeParam::D;
  State<D> s = above_a_floor<D>();
  const KF3 w{2.1 * l0};
  const double n0 = lattice_reference<D>(w, l0).n0, speed = 3;
  const auto divergence =
      divergence_of<D>(w, s, [&](const Vec<D>&) { return Vec<D>(Vec<D>::Unit(0) - speed * Vec<D>::Unit(1)); });
  // (d/n0) sum_wall (-2 u).n n.r w/r^2, n.r = l0 times the layers down
  const double one = normal_sum<D>(w, 1), two = normal_sum<D>(w, 2) / 2, unit = 2 * D / n0 * speed / l0;
  EXPECT_NEAR(divergence[test::nearest<D>(s, Vec<D>::Zero())], -unit * (one + two), 1e-12 * unit);
  EXPECT_NEAR(divergence[test::nearest<D>(s, Vec<D>::Unit(1) * l0)], -unit * two, 1e-12 * unit);
  EXPECT_NEAR(divergence[test::nearest<D>(s, -Vec<D>::Unit(1) * l0)], -unit * (one + two), 1e-12 * unit)
      << "a wall particle sees as much";
}

TYPED_TEST(Divergence, OverTheLayersBesideAWallIsAllTheFlowThatItStops) {
  constexpr int D = TypeParam::D;
  const double speed = 3;
  for (const Kernel& kernel : kernel_table(2.6 * l0))
    std::visit(
        [&](const auto& w) {
          State<D> s = above_a_floor<D>();
          const auto divergence =
              divergence_of<D>(w, s, [&](const Vec<D>&) { return Vec<D>(-speed * Vec<D>::Unit(1)); });
          double flow = 0;
          for (int layer = 0; layer < 3; ++layer)
            flow += l0 * divergence[test::nearest<D>(s, Vec<D>::Unit(1) * layer * l0)];
          EXPECT_NEAR(flow, -speed, 1e-12) << w.name;
        },
        kernel);
}

TYPED_TEST(Divergence, WithoutASingleNormalNothingCounts) {
  constexpr int D = TypeParam::D;
  State<D> s;
  s.add(Vec<D>::Zero(), Kind::fluid, Vec<D>::Zero());
  s.add(-l0 * Vec<D>::Ones(), Kind::wall, Vec<D>::Zero());
  const auto divergence = divergence_of<D>(KF3{2.6 * l0}, s, [](const Vec<D>&) { return test::slanted<D>(); });
  EXPECT_EQ(divergence[test::nearest<D>(s, Vec<D>::Zero())], 0);
}

TYPED_TEST(Divergence, PairsOfWallsAddNothing) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(50, -l0, l0);
  for (auto& kind : s.kind) kind = Kind::wall;
  for (auto& u : s.velocity) u = test::slanted<D>();
  s.velocity[0].setZero();
  for (double value : divergence_of<D>(KF3{2.6 * l0}, s, [](const Vec<D>&) { return test::slanted<D>(); }))
    EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace seiche::solver
