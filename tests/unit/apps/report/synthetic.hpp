#pragma once
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "apps/report/report.hpp"
#include "apps/run/run_info.hpp"

namespace seiche::test {

/// What a run's sensors read: elevation at the left wall, and pressure in the left corner less its rest.
struct Signals {
  std::function<double(double time)> elevation = [](double t) { return 0.01 * std::sin(2 * std::numbers::pi * t); };
  std::function<double(double time)> pressure = [](double) { return 0.0; };
};

/// A run of a tank that surges at 1 Hz, 0.2 m deep, with readings at 1 kHz until `end`.
inline apps::ReportRun report_run(const std::string& label, double end, const Signals& signals = {}) {
  apps::ReportRun one;
  one.label = label;
  apps::Scene& scene = one.run.scene;
  scene.name = "tank";
  scene.file = "tank.toml";
  scene.parameters.motion.type = MotionType::harmonic;
  scene.parameters.motion.harmonic.of = DegreeOfFreedom::surge;
  scene.parameters.motion.harmonic.frequency = 1;
  scene.parameters.motion.harmonic.amplitude = 0.005;
  scene.parameters.time.end = end;
  one.run.info = apps::run_info(scene);
  one.run.record.ending = apps::Ending{apps::Ending::Status::finished, {}, "", 2, end};
  one.run.record.statistics.least_distance = 0.0042;
  const std::size_t columns = one.run.info.sensors.size();
  for (long k = 0; k <= std::lround(1000 * end); ++k) {
    const double t = 0.001 * static_cast<double>(k);
    one.readings.time.push_back(t);
    for (std::size_t i = 0; i < columns; ++i) {
      const Column& column = one.run.info.sensors[i];
      double value = 0.12;
      if (column.kind == ColumnKind::elevation) value = signals.elevation(t);
      if (column.kind == ColumnKind::pressure) value = 1962 + signals.pressure(t);
      if (is_motion(column)) value = 0.005 * std::sin(2 * std::numbers::pi * t);
      one.readings.values.push_back(value);
    }
  }
  return one;
}

inline apps::ReportRun failed_run(const std::string& label, double end, const std::string& cause) {
  apps::ReportRun one = report_run(label, end);
  one.run.record.ending = apps::Ending{apps::Ending::Status::failed, Failure{end, 36, cause}, "", 2, end};
  return one;
}

/// Gives the left elevation something to be compared with.
inline void add_reference(apps::ReportRun& run, const std::string& label, const std::function<double(double)>& value,
                          double end) {
  render::Reference reference{
      .of = "eta_left", .label = label, .file = "theory.csv", .column = "eta_left", .series = {}};
  for (double t = 0; t <= end; t += 0.01) {
    reference.series.time.push_back(t);
    reference.series.value.push_back(value(t));
  }
  run.run.scene.look.references.push_back(reference);
}

}  // namespace seiche::test
