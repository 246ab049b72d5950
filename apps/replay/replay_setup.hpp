#pragma once
#include <memory>
#include <utility>

#include "apps/common/signals.hpp"
#include "apps/replay/replay_loop.hpp"
#include "apps/replay/replay_request.hpp"
#include "render/outputs.hpp"

// What `seiche render` and `seiche movie` have in common.
namespace seiche::apps {

/// A stored run, and how it is to be shown this time.
struct Replay {
  StoredRun run;
  Scene scene;   ///< the run's, its look changed
  RunInfo info;  ///< what sinks are told
};

/// Reads the run and changes its look. Throws BadFolder, BadScene, std::invalid_argument.
Replay set_up(const ReplayRequest& request);

/// The run's VTU files, or pictures, that are asked for; if it is to be followed, those to come as well. Throws
/// BadFolder where there are none.
FrameList list_files(const ReplayRequest& request, const StoredRun& run, FrameList::Scan scan,
                     const SignalWatch& signals);

/// Of the files that are there or, if the run is to be followed, will be.
Span span_of(const ReplayRequest& request, const FrameList& list, const RunInfo& run);

/// Draws stored frames for sinks, on this thread, while others read what comes next.
Replayed draw_again(const ReplayRequest& request, const Replay& replay, FrameList list,
                    std::vector<std::unique_ptr<render::ImageSink>> image_sinks, const SignalWatch& signals);

/// A thing that was made, as in {"movie", "out/x.mp4"}.
using MadeFile = std::pair<const char*, std::filesystem::path>;

/// Says how it ended and where everything is; returns what the program exits with.
int print_summary(const ReplayRequest& request, const Replayed& ended, double seconds,
                  const std::vector<MadeFile>& made_files);

}  // namespace seiche::apps
