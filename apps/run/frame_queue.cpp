#include "apps/run/frame_queue.hpp"

#include <chrono>
#include <exception>

#include "apps/common/stopwatch.hpp"

namespace seiche::apps {

FrameQueue::FrameQueue(Outputs& outputs, const RunInfo& run)
    : outputs_(outputs), run_(run), thread_([this] { serve(); }) {}

FrameQueue::~FrameQueue() { close(); }

void FrameQueue::push(FramePtr frame) {
  const Stopwatch watch;
  frames_.push(std::move(frame));
  waited_ += watch.seconds();
}

bool FrameQueue::failed() const { return frames_.failed(); }

void FrameQueue::close() { frames_.close(); }

bool FrameQueue::ended_within(double seconds) {
  return ended_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

std::size_t FrameQueue::waiting() const { return frames_.size(); }

long FrameQueue::taken() const { return taken_; }

std::string FrameQueue::error() const { return error_; }

double FrameQueue::waited() const { return waited_; }

// What the thread does.
void FrameQueue::serve() {
  try {
    outputs_.begin(run_);
    while (const auto frame = frames_.pop()) {
      outputs_.frame(*frame);
      ++taken_;
    }
  } catch (const std::exception& error) {
    error_ = error.what();
    frames_.fail();
  }
  add_error(error_, outputs_.end());
  end_.set_value();
}

}  // namespace seiche::apps
