#include "solver/operators/vorticity.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D, class F>
Scalars vorticity_of(State<D>& s, double spacing, F u) {
  const KF3 w{2.6 * spacing};
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = u(s.position[i]);
  return vorticity(test::measured(w, list, s), lattice_reference<D>(w, spacing).n0, s);
}

// Clockwise in the plane of x and y: vorticity of -2 along z.
template <int D>
Vec<D> turning(const Vec<D>& r) {
  return r[1] * Vec<D>::Unit(0) - r[0] * Vec<D>::Unit(1) + 5 * Vec<D>::Ones();
}

template <class T>
struct Vorticity : ::testing::Test {
  static constexpr double of_turning = T::D == 2 ? -2 : 2;
};
TYPED_TEST_SUITE(Vorticity, test::Dimensions);

TYPED_TEST(Vorticity, OfARigidRotationIsTwiceItsRateAlsoAtTheSurface) {
  constexpr int D = TypeParam::D;
  State<D> s = test::disordered<D>(test::block<D>(9), 0.2 * l0);
  int tested = 0;
  const Scalars found = vorticity_of<D>(s, l0, turning<D>);
  for (std::size_t i = 0; i < s.size(); ++i) {
    // But for the block's edges, where too few neighbours are left.
    int outer = 0;
    for (int k = 0; k < D; ++k) outer += std::abs(s.position[i][k]) > 3 * l0;
    if (outer > 1) continue;
    EXPECT_NEAR(found[i], TestFixture::of_turning, 1e-10) << s.position[i].transpose() / l0;
    ++tested;
  }
  EXPECT_GE(tested, D == 2 ? 60 : 500);
}

TYPED_TEST(Vorticity, TakesNoNoticeOfWalls) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.position[i][1] < -0.5 * l0) s.kind[i] = Kind::wall;  // stands still
  const Scalars found = vorticity_of<D>(s, l0, turning<D>);
  EXPECT_NEAR(found[test::nearest<D>(s, Vec<D>::Zero())], TestFixture::of_turning, 1e-10) << "beside the wall";
  EXPECT_EQ(found[test::nearest<D>(s, -l0 * Vec<D>::Unit(1))], 0) << "of the wall itself";
}

TYPED_TEST(Vorticity, OfAStrainAndOfALoneParticleIsZero) {
  constexpr int D = TypeParam::D;
  State<D> s = test::disordered<D>(test::block<D>(7), 0.2 * l0), lone = test::block<D>(1);
  const auto strain = [](const Vec<D>& r) { return Vec<D>(r[1] * Vec<D>::Unit(0) + r[0] * Vec<D>::Unit(1)); };
  const Scalars found = vorticity_of<D>(s, l0, strain);
  EXPECT_NEAR(found[test::nearest<D>(s, Vec<D>::Zero())], 0, 1e-10);
  lone.velocity[0] = Vec<D>::Ones();
  EXPECT_EQ(vorticity(test::measured(KF3{2.6 * l0}, test::listed(lone, 2.6 * l0), lone), 1, lone).at(0), 0);
}

// At the particle in the centre of a cloud, of the field (sin(k.r + 1), -cos(k.r + 1), ...).
template <int D>
double error(double spacing, double disorder) {
  State<D> s = test::disordered<D>(test::block<D>(7, spacing), disorder * spacing);
  const Vec<D> k = test::slanted<D>();
  const Scalars found = vorticity_of<D>(s, spacing, [&](const Vec<D>& r) {
    return Vec<D>(std::sin(k.dot(r) + 1) * Vec<D>::Unit(0) - std::cos(k.dot(r) + 1) * Vec<D>::Unit(1));
  });
  const int i = test::nearest<D>(s, Vec<D>::Zero());
  const double sine = std::sin(k.dot(s.position[i]) + 1), cosine = std::cos(k.dot(s.position[i]) + 1);
  const double z = k[0] * sine - k[1] * cosine;
  if constexpr (D == 2) return std::abs(found[i] - z);
  return std::abs(found[i] - std::hypot(k[2] * sine, k[2] * cosine, z));
}

template <int D>
double order(double spacing, double disorder) {
  return std::log2(error<D>(spacing, disorder) / error<D>(spacing / 2, disorder));
}

TYPED_TEST(Vorticity, ConvergesWithTheSquareOfTheSpacingOnALatticeAndWithTheSpacingOnADisorderedCloud) {
  EXPECT_NEAR((order<TypeParam::D>(1e-3, 0)), 2, 0.01);
  EXPECT_NEAR((order<TypeParam::D>(1e-5, 0.2)), 1, 0.05);
}

}  // namespace
}  // namespace seiche::solver
