#pragma once
#include <optional>
#include <vector>

#include "solver/sensors/gauge_line.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/sensors/sensor_list.hpp"
#include "solver/sensors/wave_gauge.hpp"

namespace seiche::solver {

/// All wave gauges of a scene. They read how far beyond still level the surface crosses their lines, along a level line
/// how far from its point; to 1e-9 l0: what round-off leaves of a lattice at rest is 0. An upright one reads the
/// surface of the columns about it, any other its line alone.
template <int D>
class WaveGauges : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    std::vector<Column> all;
    const double scale = Scales(p).length;
    for (const auto& gauge : sensors_of(p).gauge)
      all.push_back(
          {"eta_" + gauge.name, "m", "elevation, " + in_words(gauge.name), ColumnKind::elevation, Rest::zero, scale});
    return all;
  }

  explicit WaveGauges(const SensorSite<D>& site) : l0_(site.p.particles.spacing) {
    const auto pools = levels_of(site.p, site.tank);
    const auto lattice = lattice_of_columns(site.tank, site.p.gravity, l0_);
    for (const auto& gauge : sensors_of(site.p).gauge) {
      const GaugeLine<D> line = line_of(gauge, site.tank, pools);
      gauges_.push_back({line, columns_about(gauge, line, site.tank, lattice)});
    }
  }

  /// Those whose surface an upright gauge reads; nothing for any other.
  /// @param line the gauge's
  static std::optional<WaveGauge> columns_about(const Parameters::WaveGauge& gauge, const GaugeLine<D>& line,
                                                const Shape<D>& tank, const LiquidLattice<D>& lattice) {
    if (gauge.direction != std::array<double, 3>{} || gauge.crossing != Crossing::highest) return {};
    const Vec<D> foot = lattice.axes(line.point);
    return WaveGauge(foot[0], D == 3 ? foot[D - 1] : 0, foot[1], tank, lattice);
  }

  void read(const Instant<D>& now, Scalars& values) override {
    const double grain = 1e-9 * l0_;
    for (const auto& [line, columns] : gauges_) {
      const double level = now.surface.lattice().axes.height(line.point);
      const double elevation =
          columns ? columns->level(now.surface) - level : crossing_of(line, now.surface) - line.still.value_or(0);
      values.push_back(std::round(elevation / grain) * grain + 0.0);  // + 0.0: never -0
    }
  }

 private:
  struct Gauge {
    GaugeLine<D> line;
    std::optional<WaveGauge> columns;
  };

  double l0_;  ///< [m]
  std::vector<Gauge> gauges_;
};

}  // namespace seiche::solver
