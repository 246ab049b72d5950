#pragma once
#include <atomic>
#include <cstddef>
#include <future>
#include <string>
#include <thread>

#include "apps/run/outputs.hpp"
#include "render/system.hpp"

namespace seiche::apps {

/// Hands the frames of a run to its outputs, in order, on a thread of its own, so that the solver goes on while they
/// are drawn and written. Outputs begin, take frames and end on that thread alone, as OpenGL needs it.
class FrameQueue {
 public:
  /// Frames that may wait. Enough to even out a slow picture; each holds 38 bytes a particle, 38 MB for a million.
  static constexpr std::size_t depth = 4;

  /// Begins the outputs; both must outlive the queue.
  FrameQueue(Outputs& outputs, const RunInfo& run);
  ~FrameQueue();  ///< closes, and waits for the end
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// Waits while the queue is full. A frame that comes after a failure is dropped.
  void push(FramePtr frame);

  /// Whether an output has failed; all are ended then.
  bool failed() const;

  /// No frame comes any more: when those that wait are written, the outputs are ended.
  void close();

  /// Waits for the outputs to end, for so long; whether they have.
  bool ended_within(double seconds);

  std::size_t waiting() const;  ///< frames not yet taken by the outputs
  long taken() const;           ///< frames that every output has
  std::string error() const;    ///< what went wrong, empty if nothing; once they have ended
  double waited() const;        ///< wall-clock time that push() waited, all together [s]; for who pushes

 private:
  void serve();

  Outputs& outputs_;
  const RunInfo& run_;
  render::BoundedQueue<FramePtr> frames_{depth};
  std::atomic<long> taken_ = 0;
  std::string error_;  // the thread's own until it has ended
  std::promise<void> end_;
  std::future<void> ended_ = end_.get_future();
  double waited_ = 0;
  std::jthread thread_;  // last, so that it finds the rest made
};

}  // namespace seiche::apps
