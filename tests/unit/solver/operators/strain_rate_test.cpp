#include "solver/operators/strain_rate.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D, class F>
Vecs<D> viscous(const KF3& w, bool slip, State<D>& s, F u) {
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = u(s.position[i]);
  Vecs<D> out(s.size());
  strain_rate_divergence(test::measured(w, list, s), lattice_reference<D>(w, l0), slip, s, out);
  return out;
}

template <class T>
struct StrainRate : ::testing::Test {};
TYPED_TEST_SUITE(StrainRate, test::Dimensions);

TYPED_TEST(StrainRate, OfARigidMotionIsZeroOnAnyCloud) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(150, -l0, l0);
  const auto rigid = [](const Vec<D>& r) {
    return Vec<D>(Vec<D>::Ones() + 5 * (r[1] * Vec<D>::Unit(0) - r[0] * Vec<D>::Unit(1)));
  };
  for (const auto& a : viscous<D>(KF3{2.6 * l0}, true, s, rigid)) EXPECT_LT(a.norm(), 1e-8);
}

TYPED_TEST(StrainRate, KeepsMomentumAndMomentAndTakesEnergy) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(150, -l0, l0);
  const auto wild = [](const Vec<D>& r) {
    return Vec<D>(std::sin(300 * r[0]) * Vec<D>::Unit(1) + std::cos(200 * r[1]) * Vec<D>::Unit(0));
  };
  const auto force = viscous<D>(KF3{2.6 * l0}, true, s, wild);
  Vec<D> total = Vec<D>::Zero();
  double moment = 0, power = 0, size = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    total += force[i];
    moment += s.position[i][0] * force[i][1] - s.position[i][1] * force[i][0];
    power += force[i].dot(s.velocity[i]);
    size += force[i].norm();
  }
  EXPECT_LT(total.norm(), 1e-13 * size);
  EXPECT_LT(std::abs(moment), 1e-13 * size * l0);
  EXPECT_LT(power, -0.01 * size);
}

// u = y^2 along x has the Laplacian 2; the sum is 2d (d+2)/(lambda n0) sum w x^2 y^2/r^2.
TYPED_TEST(StrainRate, OfAParabolaIsItsLaplacianButForTheLatticesAnisotropy) {
  constexpr int D = TypeParam::D;
  const KF3 w{2.6 * l0};
  const Reference ref = lattice_reference<D>(w, l0);
  double sum = 0;
  for (int k = D == 3 ? -2 : 0; k <= (D == 3 ? 2 : 0); ++k)
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        const int r2 = i * i + j * j + k * k;
        if (r2 > 0) sum += w(l0 * std::sqrt(r2)) * l0 * l0 * i * i * j * j / r2;
      }
  State<D> s = test::block<D>(9);
  const auto a = viscous<D>(w, true, s, [](const Vec<D>& r) { return Vec<D>(r[1] * r[1] * Vec<D>::Unit(0)); });
  const Vec<D> centre = a[test::nearest<D>(s, Vec<D>::Zero())];
  EXPECT_NEAR(centre[0], 2 * D * (D + 2) / (ref.lambda * ref.n0) * sum, 1e-9);
  EXPECT_NEAR(centre[0], 2, 0.13 * 2);
  EXPECT_NEAR(centre[1], 0, 1e-9);
}

TYPED_TEST(StrainRate, SlipLeavesFlowAlongAWallAloneAndNoSlipBrakesIt) {
  constexpr int D = TypeParam::D;
  const auto floor = [] {
    State<D> s = test::block<D>(7);
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.position[i][1] < -0.5 * l0) s.kind[i] = Kind::wall, s.normal[i] = -Vec<D>::Unit(1);
    return s;
  };
  const auto along = [](const Vec<D>&) { return Vec<D>(Vec<D>::Unit(0)); };
  State<D> sliding = floor(), sticking = floor();
  for (const auto& a : viscous<D>(KF3{2.6 * l0}, true, sliding, along)) EXPECT_TRUE(a.isZero());
  const auto braked = viscous<D>(KF3{2.6 * l0}, false, sticking, along);
  EXPECT_LT(braked[test::nearest<D>(sticking, Vec<D>::Zero())][0], -0.1 / (l0 * l0));
}

TYPED_TEST(StrainRate, SlipBearsTheNormalStress) {
  constexpr int D = TypeParam::D;
  State<D> s;
  s.add(Vec<D>::Zero(), Kind::fluid, Vec<D>::Zero());
  s.add(-l0 * Vec<D>::Unit(1), Kind::wall, -Vec<D>::Unit(1));
  const KF3 w{2.6 * l0};
  const auto a = viscous<D>(w, true, s, [](const Vec<D>&) { return Vec<D>(-3 * Vec<D>::Unit(1)); });
  const Reference ref = lattice_reference<D>(w, l0);
  // The mirrored velocity is 3 up: a difference of 6 over the pair.
  const double expected = 2 * D * (D + 2) / (ref.lambda * ref.n0) * 6 * w(l0);
  EXPECT_NEAR(a[test::nearest<D>(s, Vec<D>::Zero())][1], expected, 1e-12 * expected);
}

}  // namespace
}  // namespace seiche::solver
