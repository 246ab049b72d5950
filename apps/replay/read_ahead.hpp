#pragma once
#include <cstddef>
#include <exception>
#include <functional>
#include <stop_token>
#include <thread>
#include <utility>

#include "render/system.hpp"

namespace seiche::apps {

/// Makes things on a thread of its own, a few ahead of who takes them, in their order. A null pointer is the last.
template <class Pointer>
class ReadAhead {
 public:
  /// Asked for one after another; the token tells when nobody waits for it any more.
  using Make = std::function<Pointer(const std::stop_token&)>;

  /// @param most that wait to be taken, 2 at least
  ReadAhead(Make make, std::size_t most)
      : make_(std::move(make)), made_(most - 1), thread_([this](const std::stop_token& stop) { serve(stop); }) {}
  ~ReadAhead() {
    thread_.request_stop();
    made_.fail();
  }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Waits for the next one; null after the last. What making it threw is thrown here, after all that was made before.
  Pointer next() {
    if (auto first = made_.pop()) return std::move(*first);
    made_.rethrow();
    return {};
  }

 private:
  void serve(const std::stop_token& stop) {
    try {
      while (!stop.stop_requested()) {
        Pointer next = make_(stop);
        if (!next || !made_.push(std::move(next))) break;
      }
      made_.close();
    } catch (...) {
      made_.close(std::current_exception());
    }
  }

  Make make_;
  render::BoundedQueue<Pointer> made_;  // beside the one that is with the thread
  std::jthread thread_;                 // last: it finds the rest made, and is waited for before anything goes
};

}  // namespace seiche::apps
