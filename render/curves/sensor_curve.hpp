#pragma once
#include <optional>
#include <string>
#include <vector>

#include "render/look.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/polyline.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// One run's readings of a sensor.
struct Trace {
  Rgb colour{};
  std::size_t column = 0;   ///< of the readings
  Series series{};          ///< readings so far
  bool broken_off = false;  ///< the run failed where they end
};

/// What one plot under the picture shows.
struct SensorCurve {
  Column column{};                ///< what it shows
  std::string title{};            ///< as in "elevation, left [m]"
  double end = 0;                 ///< of the run, and of the time axis [s]
  std::vector<Trace> traces{};    ///< one to a run; a picture of one run has one
  std::optional<Range> extent{};  ///< of all readings so far
  std::optional<Range> axis{};    ///< stands still, whatever readings come
  std::vector<Reference> references{};
};

/// The curves that `look` asks for, of those that the run has. Throws std::invalid_argument.
std::vector<SensorCurve> sensor_curves(const RunInfo& run, const Look& look);

/// Adds readings of a run to its trace.
void record(SensorCurve& curve, const Readings& readings, std::size_t trace = 0);

/// The last reading up to a time that is finite, as time and value; nothing where there is none.
std::optional<Point> latest(const Trace& trace, double time);

/// What its references span within the time axis; nothing where it has none.
std::optional<Range> reference_range(const SensorCurve& curve);

/// What its axis shows, between round numbers, unless `axis` says: at first what its references span, or else the
/// column's scale to both sides of rest. Where readings go beyond, that side's distance from the middle is doubled
/// until they don't: an axis that followed them would never stand still.
Range axis_range(const SensorCurve& curve);

/// The widest range whose labels must find room: readings seldom go beyond eight times the scale.
Range widest_range(const SensorCurve& curve);

}  // namespace seiche::render
