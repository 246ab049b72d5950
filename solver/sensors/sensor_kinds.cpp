#include "solver/sensors/sensor_kinds.hpp"

#include "solver/motion/excursion.hpp"
#include "solver/sensors/energy.hpp"
#include "solver/sensors/load_sensors.hpp"
#include "solver/sensors/pressure_sensor.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/swirl.hpp"
#include "solver/sensors/volume.hpp"
#include "solver/sensors/wave_gauges.hpp"

namespace seiche::solver {
namespace {

template <int D, template <int> class Kind>
SensorKind<D> kind() {
  return {&Kind<D>::columns,
          [](const SensorSite<D>& site) -> std::unique_ptr<Sensor<D>> { return std::make_unique<Kind<D>>(site); }};
}

template <int D>
std::vector<Column> sensor_columns(const Parameters& p) {
  std::vector<Column> all;
  for (const SensorKind<D>& kind : sensor_kinds<D>())
    for (Column& column : kind.columns(p)) all.push_back(std::move(column));
  return all;
}

}  // namespace

template <int D>
const std::vector<SensorKind<D>>& sensor_kinds() {
  static const std::vector<SensorKind<D>> kinds{kind<D, PressureSensors>(), kind<D, WaveGauges>(),
                                                kind<D, LoadSensors>(),     kind<D, EnergySensor>(),
                                                kind<D, VolumeSensor>(),    kind<D, SwirlSensor>()};
  return kinds;
}

template const std::vector<SensorKind<2>>& sensor_kinds<2>();
template const std::vector<SensorKind<3>>& sensor_kinds<3>();

std::vector<Column> columns_of(const Parameters& p) {
  std::vector<Column> all = p.dimension() == 3 ? sensor_columns<3>(p) : sensor_columns<2>(p);
  for (Column& column : motion_columns(p.motion, excursion(p))) {
    if (column.scale == 0) column.scale = Scales(p).length;  // an amplitude of 0
    all.push_back(std::move(column));
  }
  return all;
}

}  // namespace seiche::solver
