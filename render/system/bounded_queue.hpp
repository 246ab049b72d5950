#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace seiche::render {

/// Hands things from one thread to another, in order; no more than a few wait at a time.
template <class T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : most_(most) {}
  BoundedQueue(const BoundedQueue&) = delete;
  BoundedQueue& operator=(const BoundedQueue&) = delete;

  /// Waits while the queue is full. False after fail(): the thing is dropped.
  bool push(T thing) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return things_.size() < most_ || failed_; });
    if (failed_) return false;
    things_.push_back(std::move(thing));
    changed_.notify_all();
    return true;
  }

  /// Waits for the next thing; nothing after fail(), or after close() once all have been taken.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !things_.empty() || closed_ || failed_; });
    if (things_.empty()) return {};
    std::optional<T> first(std::move(things_.front()));
    things_.pop_front();
    changed_.notify_all();
    return first;
  }

  /// Who pushes will push no more. @param error why, for rethrow()
  void close(std::exception_ptr error = {}) {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    if (error) error_ = std::move(error);
    changed_.notify_all();
  }

  /// Who pops will pop no more: what waits is dropped. @param error why, for rethrow()
  void fail(std::exception_ptr error = {}) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    if (error) error_ = std::move(error);
    things_.clear();
    changed_.notify_all();
  }

  /// Throws the error that the other side gave, once.
  void rethrow() {
    std::exception_ptr error;
    {
      const std::lock_guard lock(mutex_);
      error = std::exchange(error_, {});
    }
    if (error) std::rethrow_exception(error);
  }

  bool failed() const {
    const std::lock_guard lock(mutex_);
    return failed_;
  }

  /// How many wait.
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return things_.size();
  }

 private:
  const std::size_t most_;
  mutable std::mutex mutex_;         // of all below
  std::condition_variable changed_;  // any of them
  std::deque<T> things_;
  std::exception_ptr error_;  // not yet thrown
  bool closed_ = false, failed_ = false;
};

}  // namespace seiche::render
