#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/run/stored_run.hpp"

namespace seiche::apps {

/// One of the runs that a page shows.
struct ReportRun {
  StoredRun run;
  std::string label;  ///< what it is called beside the others, as in "KF3"; not shown where it is alone
  Readings readings;  ///< stored_readings(run)
};

/// A picture of what the page shows, at a time.
struct Still {
  std::filesystem::path file;  ///< PNG
  double time = 0;             ///< [s]
};

/// What a page shows. The first run's scene says which curves, and with which references.
struct Report {
  std::string title;
  std::vector<ReportRun> runs;  ///< 1 to 9, from t = 0 on
  std::filesystem::path movie;  ///< of all of them, from t = 0 on at its real speed; empty or not there: none
  std::vector<Still> stills;    ///< of all of them, in order
  std::string command = {};     ///< that makes them again, without its folder; empty: not known
};

/// Of numbered pictures (000123.png at 123 frame intervals, the last not after `end`) no more than `most`, evenly
/// spaced, the first and the last among them.
std::vector<Still> even_stills(const std::vector<std::filesystem::path>& pictures, double frame_interval, double end,
                               std::size_t most = 13);

/// The report of one run by itself, with what is in its folder. Throws BadFolder, BadScene.
Report report_of(const StoredRun& run, const std::string& command = "");

/// Writes one self-contained HTML page: movie, stills, curves, a table of measures, what was run. A movie too large
/// to be embedded is linked by its path from the page's folder. The same runs give the same page, but for wall times.
/// Throws std::runtime_error where the page can't be written or a picture can't be read.
void write_report(const std::filesystem::path& file, const Report& report);

}  // namespace seiche::apps
