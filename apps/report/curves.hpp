#pragma once
#include <string>
#include <vector>

#include "apps/report/contents.hpp"
#include "solver/column.hpp"

namespace seiche::apps::report {

/// "Elevation, left 20mm [m]" of the column eta_left_20mm.
std::string title_of(const seiche::Column& column);

/// The same without the unit.
std::string heading_of(const seiche::Column& column);

/// One curve of a chart: a run's readings, or what they are compared with.
struct Trace {
  std::string label;
  std::size_t number = 0;  ///< of the run, or of the reference
  bool of_all = false;     ///< what every run has, as the tank's motion
  bool reference = false;
  bool failed = false;  ///< the run stopped where the trace ends
  render::Series series;
};

/// One sensor of all runs over one another.
struct Chart {
  seiche::Column column;
  std::string title;  ///< as in "Elevation, left [m]"
  double end = 0;     ///< of the time axis [s]
  std::vector<Trace> traces;
  bool means = false;  ///< the runs' traces are running means, as the title says
};

/// The sensors that the run's pictures have under them; where its look wants none there, the usual ones.
std::vector<seiche::Column> charted(const StoredRun& run);

/// Time that a run came to [s].
double reached(const ReportRun& run);

/// The latest of all runs [s].
double reached(const Report& report);

/// The references that a sensor has in the first run's scene.
std::vector<render::Reference> references_of(const Report& report, const std::string& sensor);

/// One to each charted sensor. Pressures of several runs are running means as under the pictures, and titles say so.
std::vector<Chart> charts_of(const Report& report);

/// What a chart's axis shows, between round numbers: all traces, but for what lies further beyond the usual range than
/// a quarter of it. That range is the references' and the runs' without their one reading in 500 that is furthest off;
/// a run that failed has no say in it unless all did. A spike of noise, or a tank that bursts, mustn't flatten all
/// else.
struct Extent {
  render::Range range;
  double beyond = 0;  ///< the reading furthest from the range that is left out; 0 if none is
};
Extent extent_of(const Chart& chart);

}  // namespace seiche::apps::report
