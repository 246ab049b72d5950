#include "solver/operators/volume.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/operators/reference.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

// Sum of the weights over a lattice of one particle per l0^D, the one at the origin included.
template <int D>
double sum_over(const VolumeKernel& w, const std::vector<Vec<D>>& axes, const std::vector<Vec<D>>& basis) {
  double sum = 0;
  const int m = 6;
  for (int k = D == 3 ? -m : 0; k <= (D == 3 ? m : 0); ++k)
    for (int j = -m; j <= m; ++j)
      for (int i = -m; i <= m; ++i)
        for (const Vec<D>& at : basis) {
          Vec<D> r = at + i * axes[0] + j * axes[1];
          if constexpr (D == 3) r += k * axes[2];
          sum += w(l0 * r.norm());
        }
  return sum;
}

TEST(Volume, OfTheHexagonalLatticeIsThatOfTheSquareOne) {
  const VolumeKernel w(l0);
  const double side = std::sqrt(2 / std::sqrt(3));
  const double whole = 1 + lattice_reference<2>(w, l0).n0;
  const double hexagonal = sum_over<2>(w, {{side, 0}, {0.5 * side, std::sqrt(0.75) * side}}, {{0, 0}});
  EXPECT_NEAR(hexagonal / whole, 1, 3e-5);
}

TEST(Volume, OfTheClosePackedLatticesIsThatOfTheCubicOne) {
  const VolumeKernel w(l0);
  const double whole = 1 + lattice_reference<3>(w, l0).n0;
  const double cube = std::cbrt(4);  // face-centred: four particles in a cube of this side
  const double face_centred =
      sum_over<3>(w, {{cube, 0, 0}, {0, cube, 0}, {0, 0, cube}},
                  {{0, 0, 0}, {cube / 2, cube / 2, 0}, {cube / 2, 0, cube / 2}, {0, cube / 2, cube / 2}});
  const double d = std::pow(2, 1. / 6), up = d * std::sqrt(8. / 3);  // hexagonal: two in a prism of this height
  const double hexagonal = sum_over<3>(w, {{d, 0, 0}, {d / 2, d * std::sqrt(0.75), 0}, {0, 0, up}},
                                       {{0, 0, 0}, {d / 2, d / (2 * std::sqrt(3)), up / 2}});
  EXPECT_NEAR(face_centred / whole, 1, 3e-4);
  EXPECT_NEAR(hexagonal / whole, 1, 3e-4);
}

TEST(Volume, KernelIsWendlandsC2) {
  const VolumeKernel w(l0);
  EXPECT_EQ(w(0), 1);
  EXPECT_DOUBLE_EQ(w(0.5 * w.support), 3. / 16);
  EXPECT_EQ(w(w.support), 0);
  // Its first two derivatives vanish at r_e.
  const double h = 1e-3 * w.support;
  EXPECT_LT(w(w.support - h), 1e-11);
}

template <class T>
struct VolumeExcess : ::testing::Test {};
TYPED_TEST_SUITE(VolumeExcess, test::Dimensions);

template <int D>
Scalars excess_of(State<D>& s) {
  const VolumeKernel w(l0);
  const auto list = test::listed(s, w.support);
  Scalars excess(s.size(), 7);
  volume_excess(w, 1 + lattice_reference<D>(w, l0).n0, list, s, excess);
  return excess;
}

TYPED_TEST(VolumeExcess, IsZeroOnTheLatticeAndTheShareThatIsMissing) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(9);
  EXPECT_NEAR(excess_of(s)[test::nearest<D>(s, Vec<D>::Zero())], 0, 1e-14);
  const int centre = test::nearest<D>(s, Vec<D>::Zero());
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(s.size()); ++i)
    if (i == centre || (s.position[i] - l0 * Vec<D>::Unit(0)).norm() > 0.1 * l0) kept.push_back(i);
  s.reorder(kept);
  const VolumeKernel w(l0);
  const Scalars excess = excess_of(s);
  EXPECT_NEAR(excess[test::nearest<D>(s, Vec<D>::Zero())], -w(l0) / (1 + lattice_reference<D>(w, l0).n0), 1e-14);
}

TYPED_TEST(VolumeExcess, CountsWallsAsFarAsTheyAreWet) {
  constexpr int D = TypeParam::D;
  State<D> s;
  s.add(Vec<D>::Zero(), Kind::fluid, Vec<D>::Zero());
  s.add(l0 * Vec<D>::Unit(0), Kind::wall, Vec<D>::Unit(0));
  for (std::size_t i = 0; i < 2; ++i)
    if (s.kind[i] == Kind::wall) s.wet[i] = 0.25;
  const VolumeKernel w(l0);
  const double whole = 1 + lattice_reference<D>(w, l0).n0;
  const Scalars excess = excess_of(s);
  const int fluid = s.kind[0] == Kind::fluid ? 0 : 1;
  EXPECT_NEAR(excess[fluid], (1 + 0.25 * w(l0)) / whole - 1, 1e-14);
  EXPECT_EQ(excess[1 - fluid], 0) << "of fluid only";
}

}  // namespace
}  // namespace seiche::solver
