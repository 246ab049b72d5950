#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "render/outputs.hpp"

namespace seiche::render {
namespace {

class OnThread : public ImageSink {
 public:
  explicit OnThread(std::unique_ptr<ImageSink> taker) : taker_(std::move(taker)) {}
  ~OnThread() override { join(); }

  void begin(const RunInfo& run, int width, int height) override {
    taker_->begin(run, width, height);
    thread_ = std::jthread([this] { serve(); });
  }

  void image(const Image& image, const Frame& frame) override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < depth || error_; });
    if (error_) std::rethrow_exception(std::exchange(error_, {}));
    if (failed_) return;
    Item item = std::move(spare_);
    lock.unlock();
    item.image = image;
    std::tie(item.frame.index, item.frame.step, item.frame.time) = std::tie(frame.index, frame.step, frame.time);
    lock.lock();
    waiting_.push_back(std::move(item));
    changed_.notify_all();
  }

  void end() override {
    join();
    taker_->end();
    if (error_) std::rethrow_exception(std::exchange(error_, {}));
  }

 private:
  struct Item {
    Image image;
    Frame frame;
  };
  static constexpr std::size_t depth = 3;  // of 4 bytes a pixel: 11 MB at 1280 x 720

  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return !waiting_.empty() || closed_; });
      if (waiting_.empty()) return;
      Item item = std::move(waiting_.front());
      lock.unlock();
      try {
        taker_->image(item.image, item.frame);
      } catch (...) {
        lock.lock();
        error_ = std::current_exception();
        failed_ = true;
        waiting_.clear();
        changed_.notify_all();
        return;
      }
      lock.lock();
      waiting_.pop_front();
      spare_ = std::move(item);  // its memory
      changed_.notify_all();
    }
  }

  // Lets the thread finish what waits.
  void join() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
  }

  std::unique_ptr<ImageSink> taker_;
  std::mutex mutex_;                 // of all below
  std::condition_variable changed_;  // any of them
  std::deque<Item> waiting_;         // the first one is with the taker
  Item spare_;
  std::exception_ptr error_;  // not yet told
  bool failed_ = false, closed_ = false;
  std::jthread thread_;
};

}  // namespace

std::unique_ptr<ImageSink> on_thread(std::unique_ptr<ImageSink> taker) {
  return std::make_unique<OnThread>(std::move(taker));
}

}  // namespace seiche::render
