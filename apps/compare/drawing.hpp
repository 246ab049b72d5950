#pragma once
#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/run/stored_run.hpp"
#include "render/look.hpp"
#include "render/panels.hpp"

namespace seiche::apps::compare {

/// A run that is shown beside others.
struct ComparedRun {
  std::string label;
  StoredRun run;
  Readings readings;                ///< stored_readings(run)
  std::vector<StoredFrame> frames;  ///< stored_frames(run), at least one
};

/// Throws BadFolder where the run has no frames, or what can't be used.
ComparedRun compared(std::string label, StoredRun run);

/// The clock that all runs are shown under: from 0 on in the shortest interval at whose ends every run has a frame,
/// until each has shown its last one, and one that failed its message.
struct Clock {
  double interval = 0;  ///< [s]
  long last = 0;        ///< number of the last picture
  double end = 0;       ///< its time, no later than there is something new to show [s]

  double time(long number) const { return std::min(interval * static_cast<double>(number), end); }
};

/// Throws BadFolder where the runs' frame rates have hardly a time in common.
Clock clock_of(const std::vector<ComparedRun>& runs);

/// Number of the frame that a run shows at a time: its last one up to then.
std::size_t frame_at(const ComparedRun& run, double time);

/// How the run appears beside others that last until `end`: its label tells of particles that it lost by its own end.
render::Variant variant_of(const ComparedRun& run, double end);

/// Where the pictures go.
struct Pictures {
  std::filesystem::path frames, movie;
};

/// Draws all pictures. @param progress called after each, with its number and the number of all; false ends it there
/// Returns whether it came to the end. Throws what render throws.
bool draw(const std::vector<ComparedRun>& runs, const render::Look& look, const Pictures& pictures,
          const std::function<bool(long, long)>& progress);

}  // namespace seiche::apps::compare
