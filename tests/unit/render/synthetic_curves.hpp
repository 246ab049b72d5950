#pragma once
#include <cmath>

#include "render/look.hpp"
#include "render/view/painter.hpp"
#include "tests/unit/render/synthetic.hpp"

namespace seiche::test {

/// The tank with sensors and a motion.
inline RunInfo run_with_sensors(const Box& box) {
  RunInfo run = run_info(box);
  run.sensors = {{"p_left_bottom", "Pa", "pressure, left bottom", ColumnKind::pressure, Rest::first_value, 490.5},
                 {"eta_left", "m", "elevation, left", ColumnKind::elevation, Rest::zero, 0.05},
                 {"eta_right", "m", "elevation, right", ColumnKind::elevation, Rest::zero, 0.05},
                 {"surge", "m", "surge", ColumnKind::translation, Rest::zero, 0.02}};
  return run;
}

/// What the sensors of run_with_sensors() read at a time: a sloshing that grows, with some noise on the pressure.
inline std::vector<double> reading(double time) {
  const double eta = 0.012 * time * std::sin(6.28 * time), noise = 40 * std::sin(1e4 * time * time);
  return {1962 + 4000 * eta + noise, eta, -eta, 0.02 * std::sin(6.28 * time)};
}

/// Readings from `from` to `until`, `rate` a second.
inline Readings readings(double from, double until, double rate = 100) {
  Readings all;
  for (long k = std::lround(from * rate); k <= std::lround(until * rate); ++k) {
    const double time = static_cast<double>(k) / rate;
    const auto row = reading(time);
    all.time.push_back(time);
    all.values.insert(all.values.end(), row.begin(), row.end());
  }
  return all;
}

/// A series beside the elevation at the left wall, somewhat smaller, to the end of the run.
inline render::Reference reference(double share = 0.9) {
  render::Reference reference{.of = "eta_left",
                              .label = "nonlinear potential theory",
                              .file = "theory.csv",
                              .column = "eta_left",
                              .series = {}};
  for (int k = 0; k <= 1000; ++k) {
    reference.series.time.push_back(0.01 * k);
    reference.series.value.push_back(share * reading(0.01 * k)[1]);
  }
  return reference;
}

}  // namespace seiche::test
