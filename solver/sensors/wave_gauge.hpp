#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/sensors/surface_profile.hpp"

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

}  // namespace seiche::solver
