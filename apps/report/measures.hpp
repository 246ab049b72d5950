#pragma once
#include <optional>
#include <string>
#include <vector>

#include "apps/report/contents.hpp"
#include "solver/column.hpp"

namespace seiche::apps::report {

/// A share, and the times that it was taken over.
struct Share {
  double value = 0;
  double from = 0, to = 0;  ///< [s]
};

/// How far readings are from a reference, over the times that both have.
struct Error {
  double rms = 0;      ///< root mean square of the difference, in the sensor's unit: the pictures' own figure
  double to = 0;       ///< last reading [s]
  double of_rest = 0;  ///< over that of a sensor that stayed at 0: 0 is perfect, 1 as bad as still liquid
};

/// The highest point of a wave as it passes.
struct Crest {
  double time = 0;    ///< [s]
  double height = 0;  ///< above still level [m]
};

/// What the table tells of a run's readings; what they can't tell is left out.
struct Measures {
  std::optional<Share> noise;                ///< RMS of the pressure above 10 Hz, of rho g depth
  std::vector<std::optional<Error>> errors;  ///< against each reference of the elevation
  std::vector<Crest> crests;                 ///< of the elevation, near those of the first reference if it has any
  std::optional<double> drift;               ///< of the volume: mean of the last tenth less that of the first, of it
};

/// Which sensors are measured: the first pressure and the first elevation of those charted, else of all.
struct Measured {
  std::optional<seiche::Column> pressure, elevation;
};
Measured measured_sensors(const StoredRun& run);

/// @param references of the elevation
Measures measures_of(const ReportRun& one, const Measured& sensors, const std::vector<render::Reference>& references);

/// The first crests of a reference, or of a run without one, `most` at most. One lies between a rise above `least` and
/// a fall below minus that, so that noise makes none; a wave that hasn't fallen yet has none.
std::vector<Crest> crests_of(const render::Series& elevation, double least, std::size_t most);

/// For each crest of a reference the highest reading within `reach` of it; fewer where the readings end before.
std::vector<Crest> crests_near(const render::Series& elevation, const std::vector<Crest>& crests, double reach);

/// A quarter of the motion's period, of a second where it has none [s].
double crest_reach(const Scene& scene);

/// The height that a crest passes: 1 % of the depth [m].
double least_crest(const RunInfo& run);

constexpr std::size_t most_crests = 3;

}  // namespace seiche::apps::report
