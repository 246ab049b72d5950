#pragma once
#include <optional>
#include <string>
#include <vector>

#include "render/look.hpp"
#include "solver/frame.hpp"

namespace seiche::render {

/// What one curve under the picture shows.
struct SensorCurve {
  std::string title;       ///< as in "elevation, left [m]"
  std::size_t column = 0;  ///< of the readings
  double end = 0;          ///< of the run, and of the time axis [s]
  double reach = 0;        ///< how far from rest its axis goes before anything is known
  bool about_zero = true;  ///< at rest it is 0; else whatever the first reading is
  Series series{};         ///< readings so far
  std::optional<Range> extent{};
  std::vector<Reference> references{};
};

/// The curves that `look` asks for, of those that the run has. Throws std::invalid_argument.
std::vector<SensorCurve> sensor_curves(const RunInfo& run, const Look& look);

/// Adds a frame's readings to the curve.
void record(SensorCurve& curve, const Readings& readings);

/// What its axis shows, between round numbers: at first what its references span, or else `reach` to both sides of
/// rest. Where readings go beyond, that side's distance from the middle is doubled until they don't: an axis that
/// followed them would never stand still.
Range axis_range(const SensorCurve& curve);

/// The widest range whose labels must find room: readings seldom go beyond eight times the reach.
Range widest_range(const SensorCurve& curve);

}  // namespace seiche::render
