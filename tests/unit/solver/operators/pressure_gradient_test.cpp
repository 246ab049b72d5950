#include "solver/operators/pressure_gradient.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct PressureGradientOf : ::testing::Test {};
TYPED_TEST_SUITE(PressureGradientOf, test::Dimensions);

/// The model's gradient in the middle of a block whose pressure grows as `slope`.
template <int D>
Vec<D> gradient(GradientModel model, const Vec<D>& slope, double disorder) {
  Parameters p;
  p.particles.spacing = l0;
  State<D> s = test::disordered(test::block<D>(7), disorder);
  Range<D> range(p, p.method.radius_gradient);
  range.measure(test::listed(s, 2.6 * l0), s);
  for (std::size_t i = 0; i < s.size(); ++i) s.pressure[i] = slope.dot(s.position[i]);
  Vecs<D> out;
  const Vecs<D>* no_walls = nullptr;
  PressureGradient{model}(range, no_walls, s, out);
  return out[test::nearest<D>(s, Vec<D>::Zero())];
}

TYPED_TEST(PressureGradientOf, IsExactOnLinearFieldsOfALattice) {
  constexpr int D = TypeParam::D;
  const Vec<D> slope = test::slanted<D>();
  for (const auto& [model, name, help] : ChoiceTable<GradientModel>::rows)
    EXPECT_LT((gradient<D>(model, slope, 0) - slope).norm(), 1e-12) << name;
}

TYPED_TEST(PressureGradientOf, IsExactInDisorderWhereCorrectedAlone) {
  constexpr int D = TypeParam::D;
  const Vec<D> slope = test::slanted<D>();
  EXPECT_LT((gradient<D>(GradientModel::corrected, slope, 0.2 * l0) - slope).norm(), 1e-12);
  EXPECT_GT((gradient<D>(GradientModel::plain, slope, 0.2 * l0) - slope).norm(), 1e-3);
  EXPECT_GT((gradient<D>(GradientModel::minimum, slope, 0.2 * l0) - slope).norm(), 1e-3);
}

TYPED_TEST(PressureGradientOf, OfAUniformPressureIsNone) {
  constexpr int D = TypeParam::D;
  const Vec<D> none = Vec<D>::Zero();
  for (const auto& [model, name, help] : ChoiceTable<GradientModel>::rows)
    EXPECT_EQ(gradient<D>(model, none, 0.2 * l0), none) << name;
}

}  // namespace
}  // namespace seiche::solver
