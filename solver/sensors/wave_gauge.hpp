#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/sensors/sensor_list.hpp"

namespace seiche::solver {

/// Weights of columns about a gauge at x along one axis, both in l0: a smooth local fit to their heights,
///   K(q) = (a - b q^2) W(q/3), W = KF4 of support 2, q the distance in l0,
/// a and b such that K has the moments 1, 0 and -1/3: the last takes back what the width of W in the fluid fraction
/// added (its second moment, 1/3), so that surfaces up to a parabola are exact. Beyond the ends of the row columns go
/// on as in a mirror.
inline Scalars gauge_weights(double x, int columns) {
  const double wide = 3;
  const int reach = static_cast<int>(2 * wide), first = static_cast<int>(std::floor(x)) - reach;
  const auto distance = [&](int i) { return std::abs(i + 0.5 - x); };
  const auto w = [&](int i) { return KF4{2}(distance(i) / wide); };
  double m0 = 0, m2 = 0, m4 = 0;
  for (int i = first; i <= first + 2 * reach + 1; ++i) {
    const double q2 = distance(i) * distance(i);
    m0 += w(i);
    m2 += w(i) * q2;
    m4 += w(i) * q2 * q2;
  }
  const double b = (m2 + m0 / 3) / (m4 * m0 - m2 * m2), a = (1 + b * m2) / m0;
  Scalars weights(columns, 0);
  for (int i = first; i <= first + 2 * reach + 1; ++i) {
    int column = i;
    while (column < 0 || column >= columns) column = column < 0 ? -1 - column : 2 * columns - 1 - column;
    weights[column] += (a - b * distance(i) * distance(i)) * w(i);
  }
  return weights;
}

/// Height of the surface along a vertical line, from the surface of the columns within 6 l0: their scatter averages out
/// while a wave 20 l0 long keeps 99 % of its height.
class WaveGauge {
 public:
  /// @param x, z where it stands [l0]
  /// @param columns, rows of the profile that it reads, along x and z
  WaveGauge(double x, double z, int columns, int rows) {
    const Scalars along = gauge_weights(x, columns), across = rows > 1 ? gauge_weights(z, rows) : Scalars{1};
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < columns; ++i)
        if (along[i] * across[k] != 0) weights_.push_back({i + columns * k, along[i] * across[k]});
  }

  /// Height above the floor [m], never beyond the columns that it comes from.
  template <int D>
  double level(const SurfaceProfile<D>& profile) const {
    double sum = 0, low = std::numeric_limits<double>::infinity(), high = 0;
    for (const auto& [column, weight] : weights_) {
      const double height = profile.height(column);
      sum += weight * height;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return std::clamp(sum, low, high);
  }

 private:
  struct Weight {
    int column;
    double weight;
  };
  std::vector<Weight> weights_;
};

/// All that the scene names. They read the height above still level, to 1e-9 l0: what round-off leaves of a lattice at
/// rest is 0.
template <int D>
class WaveGauges : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    std::vector<Column> all;
    for (const auto& gauge : sensors_of(p).gauge)
      all.push_back({"eta_" + gauge.name, "m", "elevation, " + in_words(gauge.name), ColumnKind::elevation, Rest::zero,
                     Scales(p).length});
    return all;
  }

  WaveGauges(const Parameters& p, const State<D>&) : depth_(p.fluid.depth), l0_(p.particles.spacing) {
    const SurfaceProfile<D> profile(p);
    for (const auto& gauge : sensors_of(p).gauge)
      gauges_.emplace_back(gauge.x / l0_, gauge.z / l0_, profile.count(0), profile.count(1));
  }

  void read(const Instant<D>& now, Scalars& values) override {
    const double grain = 1e-9 * l0_;
    for (const auto& gauge : gauges_)
      values.push_back(std::round((gauge.level(now.surface) - depth_) / grain) * grain + 0.0);  // + 0.0: never -0
  }

 private:
  double depth_, l0_;
  std::vector<WaveGauge> gauges_;
};

}  // namespace seiche::solver
