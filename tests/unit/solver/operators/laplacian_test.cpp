#include "solver/operators/laplacian.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D, class K, class F>
Vecs<D> laplacian_of(const K& w, double spacing, bool slip, State<D>& s, F u) {
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = u(s.position[i]);
  Vecs<D> out(s.size());
  velocity_laplacian(test::measured(w, list, s), lattice_reference<D>(w, spacing), slip, s, out);
  return out;
}

template <class T>
struct Laplacian : ::testing::Test {};
TYPED_TEST_SUITE(Laplacian, test::Dimensions);

TYPED_TEST(Laplacian, IsExactOnQuadraticFieldsOfALattice) {
  constexpr int D = TypeParam::D;
  Eigen::Matrix<double, D, D> a;
  for (int k = 0; k < D * D; ++k) a(k / D, k % D) = 1 + k * k;
  const auto u = [&](const Vec<D>& r) {
    return Vec<D>(r.dot(a * r) * test::slanted<D>() + a * r + Vec<D>::Constant(7));
  };
  const Vec<D> exact = 2 * a.trace() * test::slanted<D>();
  for (const Kernel& kernel : kernel_table(3.1 * l0))
    std::visit(
        [&](const auto& w) {
          State<D> s = test::block<D>(9);
          const auto laplacian = laplacian_of<D>(w, l0, true, s, u);
          for (std::size_t i = 0; i < s.size(); ++i)
            if (test::reach<D>(s.position[i]) < 1.5 * l0) {
              EXPECT_LT((laplacian[i] - exact).norm(), 1e-9 * exact.norm()) << w.name;
            }
        },
        kernel);
}

TYPED_TEST(Laplacian, IsSecondOrderOnASmoothField) {
  constexpr int D = TypeParam::D;
  const Vec<D> k = test::slanted<D>();
  const auto error = [&](double spacing) {
    State<D> s = test::block<D>(7, spacing);
    const auto laplacian = laplacian_of<D>(KF3{2.6 * spacing}, spacing, true, s, [&](const Vec<D>& r) {
      return Vec<D>(std::sin(k.dot(r) + 1) * Vec<D>::Unit(D - 1));
    });
    return std::abs(laplacian[test::nearest<D>(s, Vec<D>::Zero())][D - 1] + k.squaredNorm() * std::sin(1));
  };
  EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 2, 0.01);
}

TYPED_TEST(Laplacian, OfAUniformFlowIsZeroOnAnyCloud) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(200, -2 * l0, 2 * l0);
  for (const auto& value :
       laplacian_of<D>(KF3{2.6 * l0}, l0, false, s, [](const Vec<D>&) { return test::slanted<D>(); }))
    EXPECT_EQ(value, Vec<D>(Vec<D>::Zero()));
}

/// A block whose lower part, y < 0, is a wall and dummies below it.
template <int D>
State<D> above_a_floor() {
  State<D> s = test::block<D>(9);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.position[i][1] < -0.5 * l0) s.kind[i] = Kind::wall;
    if (s.position[i][1] < -1.5 * l0) s.kind[i] = Kind::dummy;
  }
  return s;
}

TYPED_TEST(Laplacian, FeelsNoShearFromASlippyWall) {
  constexpr int D = TypeParam::D;
  State<D> s = above_a_floor<D>();
  for (const auto& value :
       laplacian_of<D>(KF3{2.6 * l0}, l0, true, s, [](const Vec<D>&) { return test::slanted<D>(); }))
    EXPECT_EQ(value, Vec<D>(Vec<D>::Zero()));
}

TYPED_TEST(Laplacian, FeelsTheDragOfARoughWall) {
  constexpr int D = TypeParam::D;
  State<D> s = above_a_floor<D>();
  const KF3 w{2.1 * l0};
  const Reference ref = lattice_reference<D>(w, l0);
  const Vec<D> u = Vec<D>::Unit(0);
  const auto laplacian = laplacian_of<D>(w, l0, false, s, [&](const Vec<D>&) { return Vec<D>(u); });
  // What lies one and two layers below: 1 + 2 diagonal neighbours in 2-D, 1 + 4 + 4 in 3-D, and one at 2 l0.
  double below = w(l0) + (D == 2 ? 2 : 4) * w(std::sqrt(2) * l0) + w(2 * l0);
  if (D == 3) below += 4 * w(std::sqrt(3) * l0);
  const int first = test::nearest<D>(s, Vec<D>::Zero()), second = test::nearest<D>(s, Vec<D>::Unit(1) * l0);
  const double factor = 2 * D / (ref.lambda * ref.n0);
  EXPECT_LT((laplacian[first] + factor * below * u).norm(), 1e-9 * factor);
  EXPECT_LT((laplacian[second] + factor * w(2 * l0) * u).norm(), 1e-9 * factor);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] != Kind::fluid) {
      EXPECT_TRUE(laplacian[i].isZero()) << "walls and dummies stand still";
    }
}

}  // namespace
}  // namespace seiche::solver
