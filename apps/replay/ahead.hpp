#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace seiche::apps {

/// Makes things on a thread of its own, a few ahead of who takes them, in their order. A null pointer is the last.
template <class Pointer>
class Ahead {
 public:
  /// Asked for one after another; the token tells when nobody waits for it any more.
  using Make = std::function<Pointer(const std::stop_token&)>;

  /// @param most that wait to be taken
  Ahead(Make make, std::size_t most)
      : make_(std::move(make)), most_(most), thread_([this](const std::stop_token& stop) { serve(stop); }) {}
  Ahead(const Ahead&) = delete;
  Ahead& operator=(const Ahead&) = delete;

  /// Waits for the next one; null after the last. What making it threw is thrown here, after all that was made before.
  Pointer next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !made_.empty() || ended_; });
    if (made_.empty()) {
      if (error_) std::rethrow_exception(std::exchange(error_, {}));
      return {};
    }
    Pointer first = std::move(made_.front());
    made_.pop_front();
    changed_.notify_all();
    return first;
  }

 private:
  void serve(const std::stop_token& stop) {
    std::exception_ptr error;
    try {
      while (has_room(stop)) {
        Pointer next = make_(stop);
        if (!next) break;
        const std::lock_guard lock(mutex_);
        made_.push_back(std::move(next));
        changed_.notify_all();
      }
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    error_ = error;
    ended_ = true;
    changed_.notify_all();
  }

  // Waits for it; false when nobody takes any more.
  bool has_room(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [&] { return made_.size() < most_; }) && !stop.stop_requested();
  }

  Make make_;
  const std::size_t most_;
  std::mutex mutex_;                     // of all below
  std::condition_variable_any changed_;  // any of them
  std::deque<Pointer> made_;
  std::exception_ptr error_;
  bool ended_ = false;
  std::jthread thread_;  // last: it finds the rest made, and is stopped and waited for before anything goes
};

}  // namespace seiche::apps
