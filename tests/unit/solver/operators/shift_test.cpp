#include "solver/operators/shift.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <int D>
Vecs<D> shift_of(State<D>& s, double strength, std::uint8_t near_surface = 0) {
  const KF3 w{2.6 * l0};
  const auto list = test::listed(s, w.support);
  Vecs<D> shift(s.size(), Vec<D>::Ones());
  particle_shift(test::measured(w, list, s), lattice_reference<D>(w, l0).n0, strength, l0,
                 std::vector<std::uint8_t>(s.size(), near_surface), s, shift);
  return shift;
}

template <class T>
struct Shift : ::testing::Test {};
TYPED_TEST_SUITE(Shift, test::Dimensions);

TYPED_TEST(Shift, IsZeroOnALattice) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  const auto shift = shift_of(s, 0.05);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (test::reach<D>(s.position[i]) < 1.5 * l0) {
      EXPECT_LT(shift[i].norm(), 1e-14 * l0);
    }
}

TYPED_TEST(Shift, PushesIntoAGap) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  std::vector<int> all_but_one;
  const int gap = test::nearest<D>(s, Vec<D>::Zero());
  for (int i = 0; i < static_cast<int>(s.size()); ++i)
    if (i != gap) all_but_one.push_back(i);
  s.reorder(all_but_one);
  const auto shift = shift_of(s, 0.05);
  // What the gap's particle would add is missing: 0.05 l0^2 (d/n0) r_ij w/r^2 towards it.
  const KF3 w{2.6 * l0};
  const double n0 = lattice_reference<D>(w, l0).n0;
  const Vec<D> x = l0 * Vec<D>::Unit(0);
  const Vec<D> expected = -0.05 * D / n0 * w(l0) * x;
  EXPECT_LT((shift[test::nearest<D>(s, x)] - expected).norm(), 1e-12 * l0);
  EXPECT_LT((shift[test::nearest<D>(s, -x)] + expected).norm(), 1e-12 * l0);
}

TYPED_TEST(Shift, IsOfFluidAwayFromTheSurfaceOnly) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(60, -l0, l0);
  for (const auto& v : shift_of(s, 0.05, 1)) EXPECT_TRUE(v.isZero());
  for (const auto& v : shift_of(s, 0)) EXPECT_TRUE(v.isZero());
  for (auto& kind : s.kind) kind = Kind::wall;
  for (const auto& v : shift_of(s, 0.05)) EXPECT_TRUE(v.isZero());
}

TYPED_TEST(Shift, EvensOutAtTheRateThatTheSceneNames) {
  constexpr int D = TypeParam::D;
  Parameters p;
  p.particles.spacing = l0;
  p.method.shift = 0.5;
  State<D> s = test::disordered(test::block<D>(7), 0.1 * l0);
  Range<D> range(p, 2.6);
  range.measure(test::listed(s, 2.6 * l0), s);
  Vecs<D> shift, expected(s.size());
  ParticleShift{p, 2}(range, 0.001, s, shift);
  particle_shift(*range.pairs, range.ref.n0, 0.5 * 0.001 * 2 / l0, l0, s.near_surface, s, expected);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_LT((shift[i] - expected[i]).norm(), 1e-12 * l0);
}

}  // namespace
}  // namespace seiche::solver
