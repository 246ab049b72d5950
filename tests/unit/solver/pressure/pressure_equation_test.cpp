#include "solver/pressure/pressure_equation.hpp"

#include <gtest/gtest.h>

#include "solver/operators/surface_detection.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// The small tank at rest under gravity, before the pressure solve of a step.
template <int D>
struct TankAtRest {
  Parameters p;
  State<D> s;
  Interactions<D> near;
  std::unique_ptr<Walls<D>> walls;
  Forces<D> forces;
  PressureEquation<D> equation;

  struct Gravity {
    double divergence = 0;
    Vec<D> operator()(const Vec<D>&, const Vec<D>&) const { return -9.81 * Vec<D>::Unit(1); }
  };

  explicit TankAtRest(const Parameters& parameters)
      : p(parameters),
        s(fill_tank<D>(p)),
        near(p, Vec<D>::Constant(-0.05), Vec<D>::Constant(0.3), longest_support(p.method)),
        walls(make_walls<D>(p, near.density.w)),
        equation(p, std::sqrt(p.gravity.size() * p.fluid.depth)) {
    near.list.build(s);
    walls->relist(near.list, s);
    near.measure(s);
    walls->wet(near.density, Vec<D>::Unit(1), s);
    SurfaceDetection<D> detect(p.method);
    detect(near.density, s);
    forces.set_body(Gravity{}, p.fluid.density, s);
    forces.viscous.assign(s.size(), Vec<D>::Zero());
  }

  SolveReport solve(double dt) {
    equation.assemble(*walls, near, forces, p.fluid.density, dt, s);
    const SolveReport report = equation.solve(s);
    walls->extend_pressure(near.density, forces, s);
    return report;
  }
};

template <int D>
Parameters small_tank(WallModel walls, SourceTerm source) {
  Parameters p = test::small_tank<D>();
  p.method.wall_model = walls;
  p.method.source = source;
  p.pressure.solver = SolverName::cholmod;
  return p;
}

template <class T>
struct PressureEquationOf : ::testing::Test {};
TYPED_TEST_SUITE(PressureEquationOf, test::Dimensions);

TYPED_TEST(PressureEquationOf, HoldsStillWaterBetweenGhosts) {
  constexpr int D = TypeParam::D;
  TankAtRest<D> tank(small_tank<D>(WallModel::ghosts, SourceTerm::mixed));
  std::fill(tank.s.pressure.begin(), tank.s.pressure.end(), 0);
  EXPECT_TRUE(tank.solve(0.01).converged);
  // Exact but for the contact line, where walls are wet in part.
  const double little = 2e-3 * 1000 * 9.81 * tank.p.fluid.depth;
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    if (tank.s.kind[i] == Kind::fluid) {
      EXPECT_NEAR(tank.s.pressure[i], 1000 * 9.81 * (tank.p.fluid.depth - tank.s.position[i][1]), little);
    }
  }
  Vec<D> floor = Vec<D>::Constant(0.065);
  floor[1] = -0.5 * l0;
  EXPECT_NEAR(tank.s.pressure[test::nearest<D>(tank.s, floor)], 1000 * 9.81 * (0.1 + 0.5 * l0), little);
}

TYPED_TEST(PressureEquationOf, PutsNoPressureWhereTheSurfaceAndTheSourceHaveNone) {
  constexpr int D = TypeParam::D;
  TankAtRest<D> tank(small_tank<D>(WallModel::particles, SourceTerm::density));
  EXPECT_EQ(tank.walls->slope(tank.forces), nullptr);
  for (std::size_t i = 0; i < tank.s.size(); ++i) tank.s.density[i] = tank.near.density.ref.n0;
  EXPECT_TRUE(tank.solve(0.001).converged);
  for (std::size_t i = 0; i < tank.s.size(); ++i) EXPECT_NEAR(tank.s.pressure[i], 0, 1e-9) << i;
}

/// Pressure in the middle after all number densities are 1 % over n0, or the water flows together at 1/s.
template <int D>
double squeezed(const Parameters& p, double dt) {
  TankAtRest<D> tank(p);
  for (std::size_t i = 0; i < tank.s.size(); ++i) {
    tank.s.density[i] = 1.01 * tank.near.density.ref.n0;
    if (tank.s.kind[i] == Kind::fluid) tank.s.velocity[i] = -tank.s.position[i] / D;
  }
  tank.solve(dt);
  Vec<D> middle = Vec<D>::Constant(0.045);
  return tank.s.pressure[test::nearest<D>(tank.s, middle)];
}

TYPED_TEST(PressureEquationOf, GrowsWithTheSquareOfTheRateForTheDensitysSource) {
  const Parameters p = small_tank<TypeParam::D>(WallModel::particles, SourceTerm::density);
  const double once = squeezed<TypeParam::D>(p, 0.002);
  EXPECT_GT(once, 0);
  EXPECT_NEAR(squeezed<TypeParam::D>(p, 0.001) / once, 4, 1e-9);
}

TYPED_TEST(PressureEquationOf, GrowsWithTheRateForTheMixedSource) {
  const Parameters p = small_tank<TypeParam::D>(WallModel::particles, SourceTerm::mixed);
  const double once = squeezed<TypeParam::D>(p, 0.002);
  EXPECT_GT(once, 0);
  EXPECT_NEAR(squeezed<TypeParam::D>(p, 0.001) / once, 2, 1e-9);
}

TYPED_TEST(PressureEquationOf, SaysWhenItsSourceIsNotFinite) {
  constexpr int D = TypeParam::D;
  TankAtRest<D> tank(small_tank<D>(WallModel::ghosts, SourceTerm::mixed));
  tank.equation.assemble(*tank.walls, tank.near, tank.forces, 1000, 0.001, tank.s);
  EXPECT_TRUE(tank.equation.is_finite());
  const Vec<D> inside = Vec<D>::Constant(0.045);
  tank.s.velocity[test::nearest<D>(tank.s, inside)] = Vec<D>::Constant(std::numeric_limits<double>::quiet_NaN());
  tank.equation.assemble(*tank.walls, tank.near, tank.forces, 1000, 0.001, tank.s);
  EXPECT_FALSE(tank.equation.is_finite());
}

TYPED_TEST(PressureEquationOf, KeepsThePressureWhereItsSolverGivesUp) {
  constexpr int D = TypeParam::D;
  Parameters p = small_tank<TypeParam::D>(WallModel::ghosts, SourceTerm::mixed);
  p.pressure = {.solver = SolverName::sor, .tolerance = 1e-12, .max_iterations = 1};
  TankAtRest<D> tank(p);
  for (auto& pressure : tank.s.pressure) pressure = 7;
  tank.equation.assemble(*tank.walls, tank.near, tank.forces, 1000, 0.001, tank.s);
  EXPECT_FALSE(tank.equation.solve(tank.s).converged);
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    if (!tank.s.surface[i]) {
      EXPECT_EQ(tank.s.pressure[i], 7);
    }
}

}  // namespace
}  // namespace seiche::solver
