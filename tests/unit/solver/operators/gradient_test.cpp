#include "solver/operators/gradient.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// Gradient of f on a cloud, every particle fluid.
template <int D, class K, class Model, class F>
Vecs<D> gradient_of(Model model, const K& w, State<D>& s, F f) {
  const auto list = test::listed(s, w.support);
  for (std::size_t i = 0; i < s.size(); ++i) s.pressure[i] = f(s.position[i]);
  Vecs<D> out(s.size());
  pressure_gradient<D>(model, test::measured(w, list, s), lattice_reference<D>(w, l0).n0, nullptr, s, out);
  return out;
}

/// Greatest error, over the particles within `within` of the centre on each axis, on 7 + slanted.r.
template <int D, class K, class Model>
double error_on_linear_field(Model model, const K& w, State<D> s, double within) {
  const Vec<D> slope = test::slanted<D>();
  const auto gradient = gradient_of(model, w, s, [&](const Vec<D>& r) { return 7 + slope.dot(r); });
  double worst = 0;
  int checked = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (test::reach<D>(s.position[i]) < within) {
      worst = std::max(worst, (gradient[i] - slope).norm());
      ++checked;
    }
  EXPECT_GT(checked, 8);
  return worst;
}

template <class T>
struct Gradient : ::testing::Test {};
TYPED_TEST_SUITE(Gradient, test::Dimensions);

TYPED_TEST(Gradient, EveryModelIsExactOnLinearFieldsOfALattice) {
  constexpr int D = TypeParam::D;
  const State<D> s = test::block<D>(9);
  for (const Kernel& kernel : kernel_table(2.6 * l0))
    std::visit(
        [&](const auto& w) {
          EXPECT_LT(error_on_linear_field<D>(PlainGradient{}, w, s, 1.5 * l0), 1e-12) << w.name;
          EXPECT_LT(error_on_linear_field<D>(MinimumGradient{}, w, s, 1.5 * l0), 1e-12) << w.name;
          EXPECT_LT(error_on_linear_field<D>(CorrectedGradient{}, w, s, 1.5 * l0), 1e-12) << w.name;
        },
        kernel);
}

TYPED_TEST(Gradient, CorrectedIsExactOnLinearFieldsOfAnyCloud) {
  constexpr int D = TypeParam::D;
  for (double amount : {0.1, 0.3}) {
    const State<D> s = test::disordered<D>(test::block<D>(9), amount * l0);
    for (const Kernel& kernel : kernel_table(2.6 * l0))
      std::visit(
          [&](const auto& w) {
            // Up to the second layer from the outside.
            EXPECT_LT(error_on_linear_field<D>(CorrectedGradient{}, w, s, 3.4 * l0), 1e-11) << w.name;
            EXPECT_GT(error_on_linear_field<D>(PlainGradient{}, w, s, 3.4 * l0), 0.05) << "the cloud is too even";
          },
          kernel);
  }
}

TYPED_TEST(Gradient, CorrectedIsExactAtAFreeSurface) {
  constexpr int D = TypeParam::D;
  const Vec<D> slope = test::slanted<D>();
  State<D> s = test::block<D>(7);
  const auto gradient =
      gradient_of(CorrectedGradient{}, KF3{2.6 * l0}, s, [&](const Vec<D>& r) { return slope.dot(r); });
  const int top = test::nearest<D>(s, Vec<D>::Unit(1) * 3 * l0);
  EXPECT_LT((gradient[top] - slope).norm(), 1e-12);
}

TYPED_TEST(Gradient, OfAConstantIsZeroOnAnyCloud) {
  constexpr int D = TypeParam::D;
  const State<D> cloud = test::random_cloud<D>(200, -2 * l0, 2 * l0);
  const auto expect_zero = [&](auto model) {
    State<D> s = cloud;
    for (const auto& g : gradient_of(model, KF3{2.6 * l0}, s, [](const Vec<D>&) { return 7; }))
      EXPECT_EQ(g, Vec<D>(Vec<D>::Zero()));
  };
  expect_zero(PlainGradient{});
  expect_zero(MinimumGradient{});
  expect_zero(CorrectedGradient{});
}

TYPED_TEST(Gradient, OfAPairIsTheHandSum) {
  constexpr int D = TypeParam::D;
  const KF3 w{2.6 * l0};
  const double n0 = lattice_reference<D>(w, l0).n0;
  const Vec<D> x = Vec<D>::Unit(0);
  const Vec<D> along = D / n0 * 50 / l0 * w(l0) * x;  // d/n0 (f_j - f_i) r_ij w/r^2 with f_j - f_i = 50
  const auto expect = [&](auto model, const Vec<D>& at_lower, const Vec<D>& at_higher) {
    State<D> s;
    for (double at : {0., l0}) s.add(at * x, Kind::fluid, Vec<D>::Zero());
    const auto gradient = gradient_of(model, w, s, [&](const Vec<D>& r) { return r[0] > 0.5 * l0 ? 60 : 10; });
    EXPECT_LT((gradient[test::nearest<D>(s, 0 * x)] - at_lower).norm(), 1e-12 * along.norm());
    EXPECT_LT((gradient[test::nearest<D>(s, l0 * x)] - at_higher).norm(), 1e-12 * along.norm());
  };
  expect(PlainGradient{}, along, along);
  expect(MinimumGradient{}, along, Vec<D>::Zero());
  expect(CorrectedGradient{}, along, along);  // One neighbour spans no space: no correction.
}

TYPED_TEST(Gradient, DummiesHaveNoPressure) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(7);
  const Vec<D> slope = test::slanted<D>();
  for (std::size_t i = 0; i < s.size(); ++i)
    if (test::reach<D>(s.position[i]) > 1.5 * l0) s.kind[i] = Kind::dummy;
  const auto gradient = gradient_of(CorrectedGradient{}, KF3{2.6 * l0}, s,
                                    [&](const Vec<D>& r) { return test::reach<D>(r) > 1.5 * l0 ? 1e9 : slope.dot(r); });
  for (std::size_t i = 0; i < s.size(); ++i) {
    const bool dummy = s.kind[i] == Kind::dummy;
    if (dummy) {
      EXPECT_TRUE(gradient[i].isZero());
    }
    if (s.position[i].norm() < 0.1 * l0) {
      EXPECT_LT((gradient[i] - slope).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace seiche::solver
