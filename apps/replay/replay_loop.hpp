#pragma once
#include <algorithm>
#include <functional>
#include <string>

#include "apps/common/progress.hpp"
#include "apps/common/stopwatch.hpp"
#include "apps/replay/read_ahead.hpp"
#include "apps/run/outputs.hpp"

namespace seiche::apps {

/// How a replay ended.
struct Replayed {
  long frames = 0;  ///< shown
  double time = 0;  ///< of the last one [s]
  bool interrupted = false;
  std::string error;  ///< empty if none
};

/// What a replay shows, for its progress.
struct Span {
  double start = 0, end = 0;  ///< [s]
  long last = 0;              ///< frame
};

/// Hands stored frames to a sink, in order, until there are no more or `stop` says so. A sink has begin(RunInfo),
/// frame(pointer) and end(), which returns what went wrong; it is ended whatever happens.
template <class Pointer, class FrameSink>
Replayed replay_loop(ReadAhead<Pointer>& frames, FrameSink& sink, const RunInfo& run, const Span& span,
                     Progress& progress, const std::function<bool()>& stop) {
  Replayed result;
  const Stopwatch watch;
  try {
    sink.begin(run);
    while (!stop()) {
      const Pointer frame = frames.next();
      if (!frame) break;
      sink.frame(frame);
      ++result.frames;
      result.time = frame->time;
      progress.show({std::min(frame->time, span.end), span.end, frame->index, span.last, result.frames, watch.seconds(),
                     stop(), span.start, "pictures"});
    }
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  result.interrupted = stop();
  add_error(result.error, sink.end());
  progress.clear();
  return result;
}

}  // namespace seiche::apps
