#include "solver/sensors/surface_profile.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::SensedTank;

template <class T, int D = T::D>
struct SurfaceProfileOf : ::testing::Test {
  SensedTank<D> tank;

  SurfaceProfile<D> profile() const {
    SurfaceProfile<D> surface = tank.profile();
    surface.find(tank.s, tank.cells());
    return surface;
  }
  int columns() const { return D == 3 ? 20 * 12 : 20; }
  double base() const { return D == 3 ? 0.2 * 0.12 : 0.2; }
  void add_drop(double x, double y) {
    tank.s.add(tank.at(x, y) + Vec<D>(0.005 * Vec<D>::Ones()), Kind::fluid, Vec<D>::Zero());
    tank.s.surface.back() = 1;
  }
};
TYPED_TEST_SUITE(SurfaceProfileOf, test::Dimensions);

TYPED_TEST(SurfaceProfileOf, OfALatticeAtRestIsFlatToRoundOff) {
  const auto surface = this->profile();
  EXPECT_EQ(surface.count(0), 20);
  EXPECT_EQ(surface.count(1), TypeParam::D == 3 ? 12 : 1);
  for (int c = 0; c < this->columns(); ++c) EXPECT_NEAR(surface.height(c), 0.1, 1e-13) << c;
  EXPECT_NEAR(surface.volume(), 0.1 * this->base(), 1e-13);
}

// What the roof carries isn't the top of what stands below it.
TYPED_TEST(SurfaceProfileOf, HasNoVolumeWithGasBelowLiquidAtTheRoof) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += 0.05; });
  EXPECT_TRUE(std::isnan(this->profile().volume()));
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] -= 0.04; });
  EXPECT_NEAR(this->profile().volume(), 0.11 * this->base(), 0.01 * this->base()) << "away from it, it has";
}

TYPED_TEST(SurfaceProfileOf, RisesWithTheWaterByAnyPartOfASpacing) {
  constexpr int D = TypeParam::D;
  for (int tenths = 1; tenths <= 10; ++tenths) {
    this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += 0.1 * l0; });
    const auto surface = this->profile();
    for (int c = 0; c < this->columns(); ++c) EXPECT_NEAR(surface.height(c), 0.1 + 0.1 * tenths * l0, 0.01 * l0) << c;
  }
}

TYPED_TEST(SurfaceProfileOf, VolumeIsTheSpaceTakenAndNotACount) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] *= 1.1; });
  // Rows 1.1 l0 apart: the half crossing is 0.55 l0 above the topmost, at 1.1 times the depth, within 0.1 l0.
  EXPECT_NEAR(this->profile().volume(), 0.11 * this->base(), 0.1 * l0 * this->base());
}

TYPED_TEST(SurfaceProfileOf, DoesNotCountALoneDrop) {
  for (double x : {0., 0.1, 0.19}) this->add_drop(x, 0.13);
  const auto surface = this->profile();
  for (int c = 0; c < this->columns(); ++c) EXPECT_NEAR(surface.height(c), 0.1, 1e-13) << c;
}

TYPED_TEST(SurfaceProfileOf, TakesTheHighestOfTwoSurfaces) {
  constexpr int D = TypeParam::D;
  // A slab of water three layers thick held above an air gap.
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += r[1] > 0.07 ? 0.04 : 0; });
  const auto surface = this->profile();
  for (int c = 0; c < this->columns(); ++c) EXPECT_NEAR(surface.height(c), 0.14, 0.01 * l0) << c;
}

TYPED_TEST(SurfaceProfileOf, IsZeroOnADryFloor) {
  constexpr int D = TypeParam::D;
  this->tank.each_fluid([](Vec<D>& r, double&) { r[0] = std::min(r[0], 0.105); });
  const auto surface = this->profile();
  EXPECT_GT(surface.height(9), 0.09);
  EXPECT_EQ(surface.height(13), 0);
  EXPECT_EQ(surface.height(19), 0);
}

TYPED_TEST(SurfaceProfileOf, SeesAFilmOneParticleThick) {
  constexpr int D = TypeParam::D;
  SurfaceProfile<D> surface = this->tank.profile();
  std::vector<int> floor_layer;
  for (int i = 0; i < static_cast<int>(this->tank.s.size()); ++i)
    if (this->tank.s.kind[i] == Kind::fluid && this->tank.s.position[i][1] < l0) floor_layer.push_back(i);
  this->tank.s.reorder(floor_layer);
  surface.find(this->tank.s, this->tank.cells());
  for (int c = 0; c < this->columns(); ++c) EXPECT_NEAR(surface.height(c), l0, 0.02 * l0) << D << ' ' << c;
}

TYPED_TEST(SurfaceProfileOf, EndsAtTheRoofOfAFullTank) {
  constexpr int D = TypeParam::D;
  this->tank.p.fluid.depth = this->tank.p.tank.height;
  this->tank.s = fill_tank<D>(this->tank.p);
  this->tank.each_fluid([](Vec<D>& r, double&) { r[1] += 0.2 * l0; });
  const auto surface = this->profile();
  for (int c = 0; c < this->columns(); ++c) EXPECT_EQ(surface.height(c), 0.15) << c;
}

}  // namespace
}  // namespace seiche::solver
