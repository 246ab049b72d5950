#include <exception>
#include <thread>
#include <tuple>
#include <utility>

#include "render/outputs.hpp"
#include "render/system/bounded_queue.hpp"

namespace seiche::render {
namespace {

class OnThread : public ImageSink {
 public:
  explicit OnThread(std::unique_ptr<ImageSink> image_sink) : image_sink_(std::move(image_sink)) {}
  ~OnThread() override { join(); }

  void begin(const RunInfo& run, int width, int height) override {
    image_sink_->begin(run, width, height);
    thread_ = std::jthread([this] { serve(); });
  }

  void image(const Image& image, const Frame& frame) override {
    Item item{image, {}};
    std::tie(item.frame.index, item.frame.step, item.frame.time) = std::tie(frame.index, frame.step, frame.time);
    if (!waiting_.push(std::move(item))) waiting_.rethrow();
  }

  void end() override {
    join();
    image_sink_->end();
    waiting_.rethrow();
  }

 private:
  struct Item {
    Image image;
    Frame frame;
  };
  static constexpr std::size_t depth = 3;  // of 4 bytes a pixel: 11 MB at 1280 x 720

  void serve() {
    try {
      while (const auto item = waiting_.pop()) image_sink_->image(item->image, item->frame);
    } catch (...) {
      waiting_.fail(std::current_exception());
    }
  }

  // Lets the thread finish what waits.
  void join() {
    waiting_.close();
    if (thread_.joinable()) thread_.join();
  }

  std::unique_ptr<ImageSink> image_sink_;
  BoundedQueue<Item> waiting_{depth - 1};  // one more is with the sink
  std::jthread thread_;
};

}  // namespace

std::unique_ptr<ImageSink> on_thread(std::unique_ptr<ImageSink> image_sink) {
  return std::make_unique<OnThread>(std::move(image_sink));
}

}  // namespace seiche::render
