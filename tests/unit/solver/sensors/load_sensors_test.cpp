#include "solver/sensors/load_sensors.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "tests/unit/solver/sensed_tank.hpp"

namespace seiche::solver {
namespace {

using test::SensedTank;

/// Readings by column of a tank at rest under a hydrostatic pressure.
template <int D>
std::map<std::string, double> readings(const SensedTank<D>& tank) {
  LoadSensors<D> sensors(tank.site());
  const FluidCells<D> cells = tank.cells();
  const SurfaceProfile<D> surface = tank.profile();
  const Budget<D> budget;
  Scalars values;
  sensors.read({tank.s, cells, surface, budget}, values);
  std::map<std::string, double> all;
  const auto columns = LoadSensors<D>::columns(tank.p);
  EXPECT_EQ(columns.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k) all[columns[k].name] = values[k];
  return all;
}

Parameters::LoadSensor on(const char* patch, std::array<double, 3> about = {}, LoadAxes axes = LoadAxes::tank) {
  return {.name = patch, .on = patch, .about = about, .axes = axes};
}

template <class T>
struct LoadSensorsOf : ::testing::Test {};
TYPED_TEST_SUITE(LoadSensorsOf, test::Dimensions);

// The small tank: 0.2 m x 0.1 m of water, 0.12 m wide in 3-D.
TYPED_TEST(LoadSensorsOf, APatchBearsWhatTheHydrostaticLawSays) {
  constexpr int D = TypeParam::D;
  Parameters p = test::small_tank<D>();
  p.sensors.load = {on("floor"), on("right", {0.2, 0.1, 0}), on("tank")};
  const double wide = D == 3 ? 0.12 : 1, weight = 9810 * 0.2 * 0.1 * wide, end = 9810 * 0.005 * wide;
  auto all = readings<D>(SensedTank<D>(p));
  EXPECT_NEAR(all["force_y_floor"], -weight, 1e-10 * weight);
  EXPECT_NEAR(all["force_x_right"], end, 1e-10 * end);
  EXPECT_NEAR(all["force_x_tank"], 0, 1e-10 * weight);
  EXPECT_EQ(all["force_y_tank"], all["force_y"]);
  // The end wall is pressed two thirds of the depth below the level, the floor in its middle.
  const std::string about_z = D == 3 ? "moment_z_" : "moment_";
  EXPECT_NEAR(all[about_z + "right"], end * 0.2 / 3, 1e-10 * end);
  EXPECT_NEAR(all[about_z + "floor"], -weight * 0.1, 1e-10 * weight);
  if (D == 3) {
    EXPECT_NEAR(all["moment_x_floor"], weight * 0.06, 1e-10 * weight);
    EXPECT_NEAR(all["moment_y_right"], end * 0.06, 1e-10 * end);
  }
}

TYPED_TEST(LoadSensorsOf, InTheLabsAxesTurnWithTheTank) {
  constexpr int D = TypeParam::D;
  Parameters p = test::small_tank<D>();
  p.sensors.load = {on("floor", {}, LoadAxes::lab)};
  // A roll of 30 degrees at t = 0.
  p.motion = {.type = MotionType::harmonic,
              .harmonic = {.of = DegreeOfFreedom::roll, .amplitude = 30, .frequency = 1, .phase = 90}};
  const double weight = 9810 * 0.2 * 0.1 * (D == 3 ? 0.12 : 1);
  auto all = readings<D>(SensedTank<D>(p));
  EXPECT_NEAR(all["force_x_floor"], 0.5 * weight, 1e-9 * weight);
  EXPECT_NEAR(all["force_y_floor"], -std::sqrt(0.75) * weight, 1e-9 * weight);
}

// Of both sides of a plate between equal levels; behind it where one side is dry.
TEST(LoadSensors, OnABaffleAreOfBothItsSides) {
  Parameters p = test::small_tank<2>();
  p.tank.baffles = {{.points = {{0.1, 0}, {0.1, 0.15}}}};
  p.sensors.load = {on("baffle", {0.1, 0, 0})};
  const double end = 9810 * 0.005;
  auto both = readings<2>(SensedTank<2>(p));
  EXPECT_NEAR(both["force_x_baffle"], 0, 1e-9 * end);
  p.fluid.seeds = {{.x = 0.05, .y = 0.05, .z = 0, .depth = 0.1}};
  auto left = readings<2>(SensedTank<2>(p));
  EXPECT_NEAR(left["force_x_baffle"], end, 0.01 * end);
  EXPECT_NEAR(left["moment_baffle"], -end * 0.1 / 3, 0.02 * end * 0.1 / 3);
}

}  // namespace
}  // namespace seiche::solver
