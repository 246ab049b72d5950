#include "solver/sensors/sensor_list.hpp"

#include <gtest/gtest.h>

#include "solver/make_simulation.hpp"
#include "tests/unit/headers.hpp"
#include "tests/unit/solver/expect_refused.hpp"

namespace seiche {
namespace {

using Names = std::vector<std::string>;
using test::expect_refused;

TEST(SensorColumns, OfTheDefaults) {
  Parameters p;
  EXPECT_EQ(
      test::headers(sensor_columns(p)),
      (Names{"p_left_bottom [Pa]", "eta_left [m]", "eta_right [m]", "force_x [N/m]", "force_y [N/m]", "moment [N m/m]",
             "kinetic_energy [J/m]", "potential_energy [J/m]", "volume [m^2]", "x_mass [m]", "y_mass [m]"}));
  p.tank.width = 0.1;
  EXPECT_EQ(test::headers(sensor_columns(p)),
            (Names{"p_left_bottom [Pa]", "eta_left [m]", "eta_right [m]", "force_x [N]", "force_y [N]", "force_z [N]",
                   "moment [N m]", "kinetic_energy [J]", "potential_energy [J]", "volume [m^3]", "x_mass [m]",
                   "y_mass [m]", "z_mass [m]", "swirl [kg m^2/s]"}));
}

TEST(SensorColumns, OfAListInItsOrder) {
  Parameters p;
  p.sensors.pressure = {{"roof", 0.3, 0.4, 0, 0.01}, {"floor", 0.3, 0, 0, 0}};
  p.sensors.gauge = {{"mid", 0.3, 0}};
  p.sensors.force = p.sensors.energy = p.sensors.volume = false;
  EXPECT_EQ(test::headers(sensor_columns(p)), (Names{"p_roof [Pa]", "p_floor [Pa]", "eta_mid [m]"}));
}

TEST(SensorColumns, EndWithTheMotion) {
  Parameters p;
  p.motion.type = MotionType::harmonic;
  p.motion.harmonic.amplitude = 0.01;
  p.motion.harmonic.frequency = 1;
  EXPECT_EQ(sensor_columns(p).back(), (Column{"surge", "m", "surge", ColumnKind::translation, Rest::zero, 0.01}));
  p.motion.harmonic.amplitude = 0;
  EXPECT_EQ(sensor_columns(p).back().scale, 0.05) << "an axis needs a length";
}

// 0.2 m of water over 0.6 m: 1962 Pa, 0.12 m^2, 1177.2 N/m.
TEST(SensorColumns, SayWhatTheyAreWhereTheyRestAndHowFarTheyGo) {
  const auto columns = sensor_columns(Parameters{});
  const auto expect = [&](const char* name, const char* title, ColumnKind kind, Rest rest, double scale) {
    const Column& column = columns.at(find_column(columns, name));
    EXPECT_EQ(column.title, title);
    EXPECT_EQ(column.kind, kind) << name;
    EXPECT_EQ(column.rest, rest) << name;
    EXPECT_NEAR(column.scale, scale, 1e-12 * scale) << name;
  };
  expect("p_left_bottom", "pressure, left bottom", ColumnKind::pressure, Rest::first_value, 490.5);
  expect("eta_left", "elevation, left", ColumnKind::elevation, Rest::zero, 0.05);
  expect("force_x", "force x", ColumnKind::force, Rest::zero, 117.72);
  expect("force_y", "force y", ColumnKind::force, Rest::first_value, 117.72);
  expect("moment", "moment", ColumnKind::moment, Rest::first_value, 70.632);
  expect("kinetic_energy", "kinetic energy", ColumnKind::energy, Rest::zero, 2.3544);
  expect("volume", "volume", ColumnKind::volume, Rest::first_value, 0.0012);
  expect("y_mass", "y mass", ColumnKind::centre, Rest::first_value, 0.05);
}

TEST(SensorColumns, TellAMaximumFromAMean) {
  Parameters p;
  p.sensors.pressure = {{"roof", 0.3, 0.4, 0, 0.1, PressureReading::maximum}, {"roof", 0.3, 0.4, 0, 0.1}};
  const auto columns = sensor_columns(p);
  EXPECT_EQ(header(columns[0]), "p_max_roof [Pa]");
  EXPECT_EQ(columns[0].title, "maximum pressure, roof");
  EXPECT_EQ(columns[0].kind, ColumnKind::pressure);
  EXPECT_EQ(columns[1].name, "p_roof");
  EXPECT_NO_THROW(check_parameters(p)) << "one place may have both";
  p.sensors.pressure[1].name = "max_roof";
  expect_refused(p, {"'p_max_roof [Pa]'", "name of its own"});
}

TEST(SensorColumns, HaveAScaleWithoutWeight) {
  Parameters p;
  p.gravity = 0;
  for (const Column& column : sensor_columns(p)) EXPECT_GT(column.scale, 0) << column.name;
}

TEST(SensorsOf, DefaultsStandMidwayAcross) {
  Parameters p;
  p.tank.width = 0.3;
  const auto sensors = solver::sensors_of(p);
  EXPECT_EQ(sensors.pressure.at(0).z, 0.15);
  EXPECT_EQ(sensors.gauge.at(0).z, 0.15);
  EXPECT_EQ(sensors.gauge.at(1).x, 0.6);
  EXPECT_NO_THROW(check_parameters(p));
}

Parameters with_pressure(double x, double y, double z = 0, double side = 0) {
  Parameters p;
  p.sensors.pressure = {{"s", x, y, z, side}};
  return p;
}

TEST(CheckSensors, WantsPressureSensorsInsideTheTank) {
  expect_refused(with_pressure(0.7, 0), {"sensors.pressure 's'", "(0.7, 0) m", "outside", "0.6 m", "0.4 m"});
  expect_refused(with_pressure(0, -0.01), {"outside"});
  expect_refused(with_pressure(0, 0.1, 0.05), {"outside", "no z"});
  Parameters deep = with_pressure(0, 0.1, 0.2);
  deep.tank.width = 0.1;
  expect_refused(deep, {"outside", "z from 0 to 0.1 m"});
}

TEST(CheckSensors, WantsAreasOnAWallAndSaysWhereOneIs) {
  expect_refused(with_pressure(0.1, 0.15, 0, 0.02), {"(0.1, 0.15) m", "on no wall", "(0, 0.15) m"});
  expect_refused(with_pressure(0.3, 0.39, 0, 0.02), {"(0.3, 0.4) m"});
  EXPECT_NO_THROW(check_parameters(with_pressure(0.1, 0.15))) << "a point may be inside";
  Parameters open = with_pressure(0.4, 0.4, 0, 0.02);
  EXPECT_NO_THROW(check_parameters(open));
  open.tank.closed = false;
  expect_refused(open, {"on no wall", "(0.6, 0.4) m"});
  Parameters wide = with_pressure(0.3, 0.2, 0.1, 0.02);
  wide.tank.width = 0.1;
  EXPECT_NO_THROW(check_parameters(wide));
  wide.sensors.pressure[0].z = 0.09;
  expect_refused(wide, {"(0.3, 0.2, 0.09) m", "(0.3, 0.2, 0.1) m"});
}

TEST(CheckSensors, TakesAPlaceWithinHalfASpacingOfTheWallAsOnIt) {
  EXPECT_NO_THROW(check_parameters(with_pressure(0.6 + 0.0024, 0.1, 0, 0.02)));
  EXPECT_NO_THROW(check_parameters(with_pressure(0.6 - 0.0024, 0.1, 0, 0.02)));
  expect_refused(with_pressure(0.6 + 0.0026, 0.1, 0, 0.02), {"outside"});
  expect_refused(with_pressure(0.6 - 0.0026, 0.1, 0, 0.02), {"on no wall"});
}

TEST(CheckSensors, WantsASideThatIsNone) { expect_refused(with_pressure(0, 0.1, 0, -0.01), {"side", "-0.01"}); }

TEST(CheckSensors, WantsGaugesInsideTheTank) {
  Parameters p;
  p.sensors.gauge = {{"far", 0.61, 0}};
  expect_refused(p, {"sensors.gauge 'far'", "x = 0.61 m", "from 0 to 0.6 m"});
  p.sensors.gauge = {{"far", 0.6, 0.1}};
  expect_refused(p, {"outside"});
  p.tank.width = 0.1;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckSensors, WantsANameOfItsOwnForEach) {
  Parameters p = with_pressure(0, 0);
  p.sensors.pressure.push_back(p.sensors.pressure[0]);
  expect_refused(p, {"sensors", "'p_s [Pa]'", "name of its own"});
  p = {};
  p.sensors.gauge = {{"a", 0, 0}, {"b", 0.1, 0}, {"a", 0.2, 0}};
  expect_refused(p, {"'eta_a [m]'"});
  p.sensors.gauge[2].name = "s";
  p.sensors.pressure = {{"a", 0, 0, 0, 0}};
  EXPECT_NO_THROW(check_parameters(p)) << "p_a and eta_a are two columns";
  for (const char* bad : {"", "two words", "a,b", "a[b]", "\"a\"", "a-b", "A"}) {
    p.sensors.gauge[2].name = bad;
    expect_refused(p, {"sensors.gauge", "column"});
  }
}

}  // namespace
}  // namespace seiche
