#include "solver/tank/filling.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::small_tank;

template <int D>
std::array<int, 3> counts(const State<D>& s) {
  std::array<int, 3> n{};
  for (Kind kind : s.kind) ++n[static_cast<int>(kind)];
  return n;
}

// 20 x 15 cells (x 12), 10 deep; one layer of wall and two of dummies (r_e = 2.6 l0).
constexpr int block_2d = 26 * 21, inside_2d = 20 * 15, walled_2d = 22 * 17;
constexpr int block_3d = block_2d * 18, inside_3d = inside_2d * 12, walled_3d = walled_2d * 14;

TEST(FillTank, CountsOfAClosedTank) {
  EXPECT_EQ(counts(fill_tank<2>(small_tank<2>())), (std::array{20 * 10, walled_2d - inside_2d, block_2d - walled_2d}));
  EXPECT_EQ(counts(fill_tank<3>(small_tank<3>())),
            (std::array{20 * 10 * 12, walled_3d - inside_3d, block_3d - walled_3d}));
}

TEST(FillTank, AnOpenTankEndsAtItsRim) {
  Parameters p = small_tank<2>();
  p.tank.closed = false;
  EXPECT_EQ(counts(fill_tank<2>(p)), (std::array{20 * 10, 22 * 16 - inside_2d, 26 * 18 - 22 * 16}));
  p = small_tank<3>();
  p.tank.closed = false;
  EXPECT_EQ(counts(fill_tank<3>(p)), (std::array{20 * 10 * 12, 22 * 16 * 14 - inside_3d, 26 * 18 * 18 - 22 * 16 * 14}));
}

TEST(FillTank, LayersFillTheLargestRadius) {
  Parameters p = small_tank<2>();
  EXPECT_EQ(wall_layers(p.method), 3);
  p.method.radius_laplacian = 3.1;
  EXPECT_EQ(wall_layers(p.method), 4);
  EXPECT_EQ(fill_tank<2>(p).size(), 28u * 23 - 20 * 5);
}

TEST(FillTank, AColumnStandsAtTheLeftWall) {
  Parameters p = small_tank<2>();
  p.fluid.column = 0.05;
  const auto s = fill_tank<2>(p);
  EXPECT_EQ(counts(s)[0], 5 * 10);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) {
      EXPECT_LT(s.position[i][0], 0.05);
    }
}

template <class T, int D = T::D>
struct FilledTank : ::testing::Test {
  Parameters p = small_tank<D>();
  Bounds<D> box = make_shape<D>(p)->bounds();
  State<D> s = fill_tank<D>(p);
};
TYPED_TEST_SUITE(FilledTank, test::Dimensions);

TYPED_TEST(FilledTank, NumbersFluidThenWallsThenDummies) {
  for (std::size_t i = 0; i < this->s.size(); ++i) {
    EXPECT_EQ(this->s.id[i], i);
    if (i > 0) {
      EXPECT_GE(this->s.kind[i], this->s.kind[i - 1]);
    }
  }
}

TYPED_TEST(FilledTank, StandsOnOneLatticeHalfASpacingOffTheWalls) {
  for (const auto& r : this->s.position)
    for (double x : r) EXPECT_NEAR(x / l0 - 0.5, std::round(x / l0 - 0.5), 1e-9);
}

/// Layers outside of the box on each axis, signed.
template <int D>
Vec<D> layers_outside(const Bounds<D>& box, const Vec<D>& r) {
  Vec<D> out = Vec<D>::Zero();
  for (int a = 0; a < D; ++a) {
    if (r[a] < 0) out[a] = std::floor(r[a] / l0);
    if (r[a] > box.high[a]) out[a] = std::ceil((r[a] - box.high[a]) / l0);
  }
  return out;
}

TYPED_TEST(FilledTank, KindsAndNormalsFollowFromThePlace) {
  constexpr int D = TypeParam::D;
  for (std::size_t i = 0; i < this->s.size(); ++i) {
    const Vec<D> out = layers_outside(this->box, this->s.position[i]);
    const double layer = out.cwiseAbs().maxCoeff();
    EXPECT_EQ(this->s.kind[i], layer == 0 ? Kind::fluid : layer == 1 ? Kind::wall : Kind::dummy);
    const Vec<D> normal = (out.array() != 0).count() == 1 ? Vec<D>(out / layer) : Vec<D>(Vec<D>::Zero());
    EXPECT_EQ(this->s.normal[i], normal) << this->s.position[i].transpose() / l0;
  }
}

TYPED_TEST(FilledTank, IsAtRestUnderHydrostaticPressure) {
  for (std::size_t i = 0; i < this->s.size(); ++i) {
    const bool fluid = this->s.kind[i] == Kind::fluid;
    EXPECT_NEAR(this->s.pressure[i], fluid ? 1000 * 9.81 * (0.1 - this->s.position[i][1]) : 0, 1e-9);
    EXPECT_TRUE(this->s.velocity[i].isZero());
  }
}

}  // namespace
}  // namespace seiche::solver
