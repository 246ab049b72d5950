#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/run/run_json.hpp"
#include "apps/scene/scene.hpp"
#include "render/look.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::apps {

/// A run in its folder, as `seiche run` left it or is still filling it.
struct StoredRun {
  std::filesystem::path folder;
  Scene scene;       ///< all of it, with the samples of its motion and of its references
  RunInfo info;      ///< as the run's own sinks were given it
  RunRecord record;  ///< without an ending: the run is still going, or was killed
};

/// Reads DIR/run.json. Throws BadFolder: the folder isn't there, is empty or holds no run, or what in run.json is
/// wrong.
StoredRun read_run(const std::filesystem::path& folder);

/// One of the run's VTU files.
struct StoredFrame {
  long index = 0;   ///< Frame::index
  double time = 0;  ///< [s]
  std::filesystem::path file;
};

/// What NAME.vtu.series lists so far, in order; none where the run wrote none. Throws BadFolder.
std::vector<StoredFrame> stored_frames(const StoredRun& run);

/// Throws BadFolder for the first whose file isn't there.
void check_there(const std::vector<StoredFrame>& frames);

/// The run's pictures, frames/000123.png, in order.
std::vector<std::filesystem::path> stored_pictures(const StoredRun& run);

/// All that probes.csv holds so far, with the columns of RunInfo::sensors; a last line that is being written is left
/// out. Empty where the run wrote none. Throws BadFolder, BadScene.
Readings stored_readings(const StoredRun& run);

/// One column of the readings, by its name, over time; empty where there is none.
render::Series column_of(const Readings& readings, const RunInfo& info, const std::string& sensor);

}  // namespace seiche::apps
