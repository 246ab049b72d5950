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

}  // namespace seiche::apps
