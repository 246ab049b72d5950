#include <gtest/gtest.h>

#include "solver/operators/gradient.hpp"
#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

// Orders of accuracy: the same cloud at ever smaller spacings, around one point of a smooth field.
namespace seiche::solver {
namespace {

/// Error of the gradient of sin(slanted.r + 1) at the particle in the centre.
template <int D, class Model>
double error(Model model, double spacing, double disorder) {
  State<D> s = test::disordered<D>(test::block<D>(7, spacing), disorder * spacing);
  const KF3 w{2.6 * spacing};
  const auto list = test::listed(s, w.support);
  const Vec<D> k = test::slanted<D>();
  for (std::size_t i = 0; i < s.size(); ++i) s.pressure[i] = std::sin(k.dot(s.position[i]) + 1);
  Vecs<D> out(s.size());
  pressure_gradient<D>(model, test::measured(w, list, s), lattice_reference<D>(w, spacing).n0, nullptr, s, out);
  const int i = test::nearest<D>(s, Vec<D>::Zero());
  return (out[i] - std::cos(k.dot(s.position[i]) + 1) * k).norm();
}

template <int D, class Model>
double order(Model model, double disorder) {
  constexpr double spacing = 1e-3;
  return std::log2(error<D>(model, spacing, disorder) / error<D>(model, spacing / 2, disorder));
}

template <class T>
struct GradientOrder : ::testing::Test {};
TYPED_TEST_SUITE(GradientOrder, test::Dimensions);

TYPED_TEST(GradientOrder, IsTwoOnALattice) {
  constexpr int D = TypeParam::D;
  EXPECT_NEAR(order<D>(PlainGradient{}, 0), 2, 0.01);
  EXPECT_NEAR(order<D>(MinimumGradient{}, 0), 2, 0.01);
  EXPECT_NEAR(order<D>(CorrectedGradient{}, 0), 2, 0.01);
}

TYPED_TEST(GradientOrder, OfTheCorrectedOneIsOneOnADisorderedCloud) {
  EXPECT_NEAR((order<TypeParam::D>(CorrectedGradient{}, 0.2)), 1, 0.05);
}

TYPED_TEST(GradientOrder, OfThePlainOneIsZeroOnADisorderedCloud) {
  EXPECT_NEAR((order<TypeParam::D>(PlainGradient{}, 0.2)), 0, 0.05);
}

}  // namespace
}  // namespace seiche::solver
