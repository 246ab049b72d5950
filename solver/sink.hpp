#pragma once
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche {

/// Something that takes the frames of a run, in order: a picture series, a movie, a set of files.
/// A run is a loop that steps the solver and hands frames to sinks; a replay hands stored frames to the same sinks.
/// Any call may throw std::runtime_error with one sentence fit for the user.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void begin(const RunInfo& run) = 0;
  virtual void frame(const FramePtr& frame) = 0;
  virtual void end() = 0;  ///< after the last frame, also when the run failed or was interrupted
};

}  // namespace seiche
