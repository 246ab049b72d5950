#include "tests/unit/solver/still_tank.hpp"

#include <gtest/gtest.h>

#include "solver/operators/gradient.hpp"

// Still water is an exact solution of the scheme with ghost walls.
namespace seiche::solver {
namespace {

using test::l0;
using test::StillTank;

template <class T>
struct StillWater : ::testing::Test {};
TYPED_TEST_SUITE(StillWater, test::Dimensions);

TYPED_TEST(StillWater, FreeSurfaceIsTheTopmostLayer) {
  StillTank<TypeParam::D> tank;
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    if (tank.s.kind[i] != Kind::fluid) continue;
    EXPECT_EQ(bool(tank.s.surface[i]), tank.s.position[i][1] > tank.p.fluid.depth - l0)
        << tank.s.position[i].transpose() / l0;
  }
}

TYPED_TEST(StillWater, SurfacePressureIsThatOfHalfALayer) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  tank.wet_walls();
  tank.set_surface_pressure();
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    if (!tank.s.surface[i]) continue;
    const bool fluid = tank.s.kind[i] == Kind::fluid;
    // Beside walls less by what their wetness lacks (wall_wetness_test.cpp).
    EXPECT_NEAR(tank.s.pressure[i] / (l0 * tank.slope.norm()), fluid ? 0.5 : 0, 5e-4);
  }
}

/// Residual of the row of each particle, as an error of its own pressure over rho g l0.
template <int D>
void expect_hydrostatic(const StillTank<D>& tank, PressureSystem<D>& system) {
  const SparseView a = system.matrix();
  Eigen::VectorXd exact(system.rows());
  for (int k = 0; k < system.rows(); ++k) exact[k] = tank.hydrostatic(tank.s.position[system.particle(k)]);
  const Eigen::VectorXd residual = a * exact - system.rhs();
  for (int k = 0; k < system.rows(); ++k)
    EXPECT_NEAR(residual[k] / a.coeff(k, k) / (tank.slope.norm() * l0), 0, 1e-10)
        << tank.s.position[system.particle(k)].transpose() / l0;
}

TYPED_TEST(StillWater, SolvesThePressureEquation) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  auto system = tank.system(tank.ghost());
  EXPECT_EQ(system.rows(), D == 2 ? 20 * 9 : 20 * 9 * 12);
  expect_hydrostatic(tank, system);
}

TYPED_TEST(StillWater, SolvesThePressureEquationUnderSidewaysForce) {
  constexpr int D = TypeParam::D;
  Parameters p = test::small_tank<D>();
  p.fluid.depth = p.tank.height;  // full, so that a tilted field keeps no free surface
  StillTank<D> tank(p);
  tank.slope = test::slanted<D>();
  auto system = tank.system(tank.ghost());
  Eigen::VectorXd exact(system.rows());
  for (int k = 0; k < system.rows(); ++k) exact[k] = tank.slope.dot(tank.s.position[system.particle(k)]);
  const Eigen::VectorXd residual = system.matrix() * exact - system.rhs();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-10 * tank.slope.norm() * l0);
}

TYPED_TEST(StillWater, GradientBalancesGravityEverywhere) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  Vecs<D> gradient(tank.s.size());
  pressure_gradient(CorrectedGradient{}, tank.pairs(), tank.ref.n0, &tank.everywhere(), tank.s, gradient);
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    const Vec<D> exact = tank.s.kind[i] == Kind::fluid ? tank.slope : Vec<D>(Vec<D>::Zero());
    EXPECT_LT((gradient[i] - exact).norm(), 1e-10 * tank.slope.norm()) << tank.s.position[i].transpose() / l0;
  }
}

TYPED_TEST(StillWater, GradientBalancesGravityOfADisorderedTank) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  std::mt19937_64 random(5);
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    if (tank.s.kind[i] != Kind::fluid) continue;
    tank.s.position[i] += 0.1 * l0 * test::random_vec<D>(random, -1, 1);
    tank.s.pressure[i] = tank.hydrostatic(tank.s.position[i]);
  }
  Vecs<D> gradient(tank.s.size());
  pressure_gradient(CorrectedGradient{}, tank.pairs(), tank.ref.n0, &tank.everywhere(), tank.s, gradient);
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    if (tank.s.kind[i] == Kind::fluid && tank.s.position[i][1] < tank.p.fluid.depth - l0) {
      EXPECT_LT((gradient[i] - tank.slope).norm(), 1e-10 * tank.slope.norm()) << tank.s.position[i].transpose() / l0;
    }
}

}  // namespace
}  // namespace seiche::solver
