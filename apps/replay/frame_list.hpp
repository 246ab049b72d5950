#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "apps/run/stored_run.hpp"

namespace seiche::apps {

/// Which frames of a run; all, unless told.
struct Selection {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();  ///< [s]
  long first = 0, last = std::numeric_limits<long>::max();                                               ///< by index

  bool holds(const StoredFrame& frame) const;
};

/// "A:B" as the frames from A to B, both taken in; "A:" and ":B" leave an end open, "A" is one frame. Throws
/// std::invalid_argument.
void select_frames(const std::string& text, Selection& selection);

/// Frames that stand in a run's folder, one after another; the run may be still going.
class FrameList {
 public:
  /// What is there now, in order: stored_frames, listed_pictures.
  using Scan = std::vector<StoredFrame> (*)(const StoredRun& run);
  /// Called while nothing new is there and the run goes on; false gives up, as it must once the token says so.
  using Wait = std::function<bool(const std::stop_token&)>;

  /// Scans the folder once. @param wait null: what is there now is all. Throws BadFolder.
  FrameList(const StoredRun& run, Scan scan, Selection selection, Wait wait = {});

  /// The next one that is selected; nothing after the last. Throws BadFolder.
  std::optional<StoredFrame> next(const std::stop_token& stop = {});

  /// Those selected that were found, also the ones handed out.
  const std::vector<StoredFrame>& found() const { return found_; }

  long scans() const { return scans_; }

 private:
  void rescan();

  const StoredRun& run_;
  Scan scan_;
  Selection selection_;
  Wait wait_;
  std::vector<StoredFrame> found_;
  std::size_t handed_ = 0;
  long scans_ = 0;
  bool ended_ = false;
};

/// The run's pictures, frames/000123.png; their times are whole frame intervals.
std::vector<StoredFrame> listed_pictures(const StoredRun& run);

}  // namespace seiche::apps
