#include "solver/tank/filling.hpp"

#include <gtest/gtest.h>

#include "solver/tank/level.hpp"
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

/// A tank of any shape about half a metre large, 20 spacings deep.
struct AnyTank {
  const char* name;
  Parameters p;
};

std::vector<AnyTank> any_tanks() {
  std::vector<AnyTank> all;
  const auto add = [&](const char* name, const Parameters::Tank& tank, double depth, double spacing) {
    Parameters p;
    p.tank = tank;
    p.fluid.depth = depth;
    p.particles.spacing = spacing;
    all.push_back({name, p});
  };
  add("box of no whole spacings", {.length = 0.9, .height = 0.508}, 0.093, 0.003);
  add("prism", {.shape = TankShape::prism, .length = 0, .height = 0, .points = {{0, 1}, {0.5, 1.2}, {0.1, 1.6}}}, 0.3,
      0.015);
  add("disc", {.shape = TankShape::sphere, .length = 0, .height = 0, .radius = 0.25, .section = SectionPlane{}}, 0.31,
      0.0125);
  add("membrane",
      {.shape = TankShape::membrane,
       .length = 0.5,
       .height = 0.4,
       .breadth = 0.6,
       .lower_chamfer = {0.1, 0.08},
       .upper_chamfer = {0.1, 0.1}},
      0.2, 0.017);
  add("sphere", {.shape = TankShape::sphere, .length = 0, .height = 0, .radius = 0.25}, 0.25, 0.021);
  add("lying cylinder",
      {.shape = TankShape::cylinder,
       .length = 0.5,
       .height = 0,
       .radius = 0.2,
       .axis = Axis::x,
       .ends = Head::torispherical},
      0.13, 0.02);
  return all;
}

template <int D>
void expect_filled(const Parameters& p) {
  const auto tank = make_shape<D>(p);
  const State<D> s = fill_tank<D>(p, *tank);
  const double level = tank->bounds().low[1] + p.fluid.depth, cell = std::pow(p.particles.spacing, D);
  long fluid = 0;
  double solid = 0;
  Vec<D> centre = Vec<D>::Zero();
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double distance = tank->nearest(s.position[i]).distance;
    if (s.kind[i] != Kind::fluid) {
      EXPECT_GT(distance, 0.4 * p.particles.spacing);
      solid += s.volume[i];
      continue;
    }
    ++fluid;
    centre += s.position[i];
    EXPECT_LT(distance, 0);
    EXPECT_NEAR(s.pressure[i], 1000 * 9.81 * (level - s.position[i][1]), 1e-9);
    EXPECT_GT(s.pressure[i], 0);
  }
  const double volume = volume_below(tank->surface(), level);
  EXPECT_NEAR(fluid * cell, volume, 0.51 * cell);
  if (p.tank.shape != TankShape::prism) {
    EXPECT_NEAR(centre[0] / fluid, 0.5 * (tank->bounds().low[0] + tank->bounds().high[0]), 1e-3 * p.fluid.depth);
  }
  // Three layers: some 3 l0 times the wall's area, more for the corners outside.
  EXPECT_GT(solid * cell, 3 * p.particles.spacing * area_of(tank->surface()) * 0.99);
}

TEST(FillTank, HoldsTheLiquidsVolumeInAnyTank) {
  for (const AnyTank& tank : any_tanks()) {
    SCOPED_TRACE(tank.name);
    if (tank.p.dimension() == 3)
      expect_filled<3>(tank.p);
    else
      expect_filled<2>(tank.p);
  }
}

}  // namespace
}  // namespace seiche::solver
