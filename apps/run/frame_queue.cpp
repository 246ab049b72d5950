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
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return frames_.size() < depth || failed_; });
  waited_ += watch.seconds();
  if (failed_) return;
  frames_.push_back(std::move(frame));
  changed_.notify_all();
}

bool FrameQueue::failed() const {
  const std::lock_guard lock(mutex_);
  return failed_;
}

void FrameQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool FrameQueue::ended_within(double seconds) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return ended_; });
}

std::size_t FrameQueue::waiting() const {
  const std::lock_guard lock(mutex_);
  return frames_.size();
}

long FrameQueue::taken() const {
  const std::lock_guard lock(mutex_);
  return taken_;
}

std::string FrameQueue::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

double FrameQueue::waited() const {
  const std::lock_guard lock(mutex_);
  return waited_;
}

// What the thread does.
void FrameQueue::serve() {
  try {
    outputs_.begin(run_);
    while (const FramePtr frame = next()) {
      outputs_.frame(frame);
      const std::lock_guard lock(mutex_);
      ++taken_;
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    trouble_ = error.what();
    frames_.clear();
    changed_.notify_all();
  }
  const std::string trouble = outputs_.end();
  const std::lock_guard lock(mutex_);
  add_trouble(trouble_, trouble);
  ended_ = true;
  changed_.notify_all();
}

// The next frame, once there is one; null when there will be none.
FramePtr FrameQueue::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !frames_.empty() || closed_; });
  if (frames_.empty()) return {};
  FramePtr frame = std::move(frames_.front());
  frames_.pop_front();
  changed_.notify_all();
  return frame;
}

}  // namespace seiche::apps
