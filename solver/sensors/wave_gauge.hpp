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

/// Weights of a row of columns about a gauge at x [l0], those of them alone that are open: the row of open columns
/// about the gauge, or beside it, goes on beyond its ends as in a mirror. All 0 if none is.
inline Scalars weights_of_open(double x, const std::vector<bool>& open) {
  const int count = static_cast<int>(open.size());
  int nearest = -1;
  for (int i = 0; i < count; ++i)
    if (open[i] && (nearest < 0 || std::abs(i + 0.5 - x) < std::abs(nearest + 0.5 - x))) nearest = i;
  Scalars weights(count, 0);
  if (nearest < 0) return weights;
  int first = nearest, last = nearest;
  while (first > 0 && open[first - 1]) --first;
  while (last + 1 < count && open[last + 1]) ++last;
  const Scalars inside = gauge_weights(std::clamp(x - first, 0.0, last + 1.0 - first), last + 1 - first);
  std::copy(inside.begin(), inside.end(), weights.begin() + first);
  return weights;
}

/// Height of the surface along a vertical line, from the surface of the columns within 6 l0: their scatter averages out
/// while a wave 20 l0 long keeps 99 % of its height.
class WaveGauge {
 public:
  /// @param x, z where it stands, along the lattice's axes [m]
  /// @param level of still liquid [m]: columns that the tank has there count
  template <int D>
  WaveGauge(double x, double z, double level, const Shape<D>& tank, const LiquidLattice<D>& lattice) {
    const auto cells = [&](double at, int axis) { return (at - lattice.corner[axis]) / lattice.l0; };
    Vec<D> r = Vec<3>(x, level, z).template head<D>();
    const auto open_along = [&](int axis) {
      std::vector<bool> open;
      for (int i = 0; i < lattice.count[axis]; ++i) {
        Vec<D> centre = r;
        centre[axis] = lattice.corner[axis] + (i + 0.5) * lattice.l0;
        open.push_back(tank.nearest(lattice.axes.in_tank(centre)).distance < 0);
      }
      return open;
    };
    // A gauge may stand on a wall: rows run through the columns' centres.
    for (int axis = 0; axis < D; axis += 2) {
      const double column = std::clamp(std::floor(cells(r[axis], axis)), 0.0, lattice.count[axis] - 1.0);
      r[axis] = lattice.corner[axis] + (column + 0.5) * lattice.l0;
    }
    const Scalars along = weights_of_open(cells(x, 0), open_along(0));
    const Scalars across = D == 3 ? weights_of_open(cells(z, D - 1), open_along(D - 1)) : Scalars{1};
    const int columns = static_cast<int>(along.size()), rows = static_cast<int>(across.size());
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < columns; ++i)
        if (along[i] * across[k] != 0) weights_.push_back({i + columns * k, along[i] * across[k]});
  }

  /// Whether there are columns to read.
  bool reads() const { return !weights_.empty(); }

  /// The surface's y along the lattice's axes [m], never beyond the columns that it comes from.
  template <int D>
  double level(const SurfaceProfile<D>& profile) const {
    double sum = 0, low = std::numeric_limits<double>::infinity(), high = -low;
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
