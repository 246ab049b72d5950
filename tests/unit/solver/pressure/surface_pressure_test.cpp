#include "solver/pressure/surface_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/modes/standing_wave.hpp"
#include "solver/operators/divergence.hpp"
#include "solver/operators/strain_rate.hpp"
#include "solver/pressure/pressure_solver.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::StillTank;

template <class T>
struct SurfacePressure : ::testing::Test {};
TYPED_TEST_SUITE(SurfacePressure, test::Dimensions);

TYPED_TEST(SurfacePressure, DensityOfTheTopmostLayerIsWhatAStillTankHas) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  Vec<D> r = Vec<D>::Constant(0.065);
  r[1] = 0.095;
  EXPECT_NEAR(surface_depth<D>(tank.w, l0).topmost, tank.n[test::nearest<D>(tank.s, r)], 1e-12);
}

TEST(SurfaceDepth, GrowsFromADropToTheTopmostLayer) {
  const SurfaceDepth depth{l0, 2};
  EXPECT_DOUBLE_EQ(depth(0), 0);
  EXPECT_DOUBLE_EQ(depth(0.5), 0.125 * l0);
  EXPECT_DOUBLE_EQ(depth(2), 0.5 * l0);
  EXPECT_DOUBLE_EQ(depth(2.4), 0.5 * l0);
}

TYPED_TEST(SurfacePressure, HoldsTheAccelerationAboveTheCentre) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(2);
  for (auto& flag : s.surface) flag = 1;
  s.surface[2] = 0;
  s.pressure[2] = 77;
  s.kind[3] = Kind::wall;
  Scalars n(s.size(), 2);
  n[1] = 1;
  const Vecs<D> force(s.size(), Vec<D>(10 * Vec<D>::Unit(0)));
  Vecs<D> viscous(s.size(), Vec<D>::Zero());
  const SurfaceDepth depth{l0, 2};
  set_surface_pressure(100, force, viscous, depth, n, s);
  EXPECT_DOUBLE_EQ(s.pressure[0], 0.5 * l0 * 1000);
  EXPECT_DOUBLE_EQ(s.pressure[1], 0.25 * l0 * 1000) << "a drop";
  EXPECT_EQ(s.pressure[2], 77) << "not at the surface";
  EXPECT_EQ(s.pressure[3], 0) << "a wall";
  viscous[0] = 3 * Vec<D>::Unit(0) + 50 * Vec<D>::Unit(1);
  viscous[1] = -11 * Vec<D>::Unit(0);
  set_surface_pressure(100, force, viscous, depth, n, s);
  EXPECT_DOUBLE_EQ(s.pressure[0], 0.5 * l0 * 1300) << "of the viscous force what acts along f";
  EXPECT_EQ(s.pressure[1], 0) << "no suction";
}

// In potential flow of viscosity nu the viscous force is 0 and the pressure below a free surface that bears no normal
// stress is 2 rho nu k^2 phi: so it is at the surface, and it is harmonic. Without the viscous part of the surface
// pressure the liquid gets 0.54 of it, on any spacing.
TEST(SurfacePressure, LetsTheLiquidFeelTheNormalViscousStress) {
  Parameters p;
  p.particles.spacing = l0;
  p.tank.length = 0.6;
  p.tank.height = 0.3;
  p.fluid.depth = 0.2;
  p.fluid.wave_amplitude = 0.005;
  StillTank<2> tank(p);
  const modes::StandingWave wave(p, p.tank.length);
  State<2>& s = tank.s;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) s.velocity[i] = wave.velocity<2>(s.position[i]);
  tank.wet_walls();
  Vecs<2> viscous(s.size());
  strain_rate_divergence(tank.pairs(), tank.ref, true, s, viscous);  // of nu = 1

  // The equation is linear: of a body force so great that nothing is suction, its own part is taken off again.
  tank.slope.setZero();
  const SurfaceDepth depth = surface_depth<2>(tank.w, l0);
  const double great = 1e6;
  set_surface_pressure(1, Vecs<2>(s.size(), -great * Vec<2>::Unit(1)), viscous, depth, tank.n, s);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.surface[i] && s.kind[i] == Kind::fluid) s.pressure[i] -= great * depth(tank.n[i]);

  PressureSystem<2> system = tank.system(tank.ghost(), 1e-7 * tank.ref.n0);
  Scalars divergence(s.size());
  s.velocity = viscous;
  VelocityGradients<2> gradient(s.size());
  velocity_divergence(tank.pairs(), tank.ref.n0, s, divergence, gradient);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rows());
  for (int k = 0; k < system.rows(); ++k)
    system.rhs()[k] -= tank.ref.lambda * tank.ref.n0 / 4 * divergence[system.particle(k)];
  make_pressure_solver(SolverName::cholmod, 0, 0)->solve(system.matrix(), system.rhs(), x);

  // phi = u_x/(-k tan(k x)) of the wave's flow; least squares over what lies well below the surface.
  const double k = std::numbers::pi / p.tank.length;
  double along = 0, whole = 0;
  for (int row = 0; row < system.rows(); ++row) {
    const Vec<2> r = s.position[system.particle(row)];
    if (r[1] > 0.75 * p.fluid.depth) continue;
    const double exact = 2 * k * k * wave.velocity<2>(r)[0] / (-k * std::tan(k * r[0]));
    along += x[row] * exact;
    whole += exact * exact;
  }
  EXPECT_NEAR(along / whole, 1, 0.03);
}

}  // namespace
}  // namespace seiche::solver
