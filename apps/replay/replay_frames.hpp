#pragma once
#include "apps/replay/frame_list.hpp"

namespace seiche::apps {

/// Reads a run's frames as its own sinks were given them: each with the readings taken since the one before.
class ReplayFrames {
 public:
  ReplayFrames(const StoredRun& run, FrameList list) : run_(run), list_(std::move(list)) {}

  /// The next frame; null after the last. Throws std::runtime_error, BadFolder, BadScene.
  FramePtr next(const std::stop_token& stop = {});

  /// Hands out all readings with the first frame: the curves' axes then stand still.
  void hand_out_all_readings() { all_at_once_ = true; }

 private:
  Readings readings_until(double time);

  const StoredRun& run_;
  FrameList list_;
  Readings readings_;  // all that are stored
  long scans_ = 0;     // the list's when they were read
  std::size_t handed_ = 0;
  bool all_at_once_ = false;
};

}  // namespace seiche::apps
