#pragma once
#include <optional>

#include "solver/sensors/surface_profile.hpp"
#include "solver/tank/pools.hpp"

namespace seiche::solver {

/// The line of a wave gauge, as far as it goes through the tank about its point.
template <int D>
struct GaugeLine {
  Vec<D> point;                   ///< [m]
  Vec<D> direction;               ///< unit vector
  double low = 0, high = 0;       ///< ends within the tank, counted from the point along the line [m]
  std::optional<double> still{};  ///< where it crosses still level [m]; none: it is level itself
  Crossing crossing = Crossing::highest;

  Vec<D> at(double along) const { return point + along * direction; }
};

/// Up, against gravity, or as its direction says. Without a direction the point is where the still level is.
/// @param pools of the liquid at rest: the line's level is that of the one nearest beside it
template <int D>
GaugeLine<D> line_of(const Parameters::WaveGauge& gauge, const Shape<D>& tank, const std::vector<Pool<D>>& pools);

/// Where the surface crosses the line [m]: of the highest crossing the end of the topmost liquid on it, its lower end
/// where it is dry; of the lowest the end of the liquid that begins at its lower end. Second order in l0.
template <int D>
double crossing_of(const GaugeLine<D>& line, const SurfaceProfile<D>& surface);

}  // namespace seiche::solver
