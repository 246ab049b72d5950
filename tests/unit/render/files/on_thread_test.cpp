#include <gtest/gtest.h>

#include <functional>
#include <latch>
#include <stdexcept>
#include <thread>

#include "render/outputs.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

struct Log {
  std::vector<long> indices;
  std::vector<std::uint8_t> first_bytes;
  std::vector<std::string> calls;
  std::thread::id thread;
  std::function<void(long)> on_image = [](long) {};
};

class Noting : public ImageSink {
 public:
  explicit Noting(Log& log) : log_(log) {}
  void begin(const RunInfo& run, int width, int height) override {
    log_.calls.push_back("begin " + run.name + " " + std::to_string(width) + " " + std::to_string(height));
  }
  void image(const Image& image, const Frame& frame) override {
    log_.thread = std::this_thread::get_id();
    log_.on_image(frame.index);
    log_.indices.push_back(frame.index);
    log_.first_bytes.push_back(image.rgba.at(0));
  }
  void end() override { log_.calls.emplace_back("end"); }

 private:
  Log& log_;
};

void hand(ImageSink& sink, long index) {
  Frame frame;
  frame.index = index;
  sink.image({1, 1, {static_cast<std::uint8_t>(index), 0, 0, 255}}, frame);
}

RunInfo named(const char* name) {
  RunInfo run;
  run.name = name;
  return run;
}

std::string error_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(OnThread, KeepsOrderAndPicturesAndEndsWhenAllAreTaken) {
  Log log;
  const auto sink = on_thread(std::make_unique<Noting>(log));
  sink->begin(named("a"), 4, 3);
  for (long index = 0; index < 100; ++index) hand(*sink, index);
  sink->end();
  ASSERT_EQ(log.indices.size(), 100u);
  for (long index = 0; index < 100; ++index) {
    const auto k = static_cast<std::size_t>(index);
    EXPECT_EQ(log.indices[k], index);
    EXPECT_EQ(log.first_bytes[k], index) << "its own picture";
  }
  EXPECT_NE(log.thread, std::this_thread::get_id());
  EXPECT_EQ(log.calls, (std::vector<std::string>{"begin a 4 3", "end"}));
}

TEST(OnThread, TakesThePictureAlongSoThatItsMemoryIsFree) {
  Log log;
  std::latch gate(1);
  log.on_image = [&](long) { gate.wait(); };
  const auto sink = on_thread(std::make_unique<Noting>(log));
  sink->begin(named("a"), 1, 1);
  Image image{1, 1, {7, 0, 0, 255}};
  sink->image(image, {});
  image.rgba[0] = 9;
  gate.count_down();
  sink->end();
  EXPECT_EQ(log.first_bytes, (std::vector<std::uint8_t>{7}));
}

TEST(OnThread, AFailureIsToldOnceAndEndsTheSinkAllTheSame) {
  Log log;
  log.on_image = [](long index) {
    if (index == 2) throw std::runtime_error("the disk is full");
  };
  const auto sink = on_thread(std::make_unique<Noting>(log));
  sink->begin(named("a"), 1, 1);
  std::string told = "none";
  for (long index = 0; index < 50 && told == "none"; ++index) told = error_of([&] { hand(*sink, index); });
  EXPECT_EQ(told, "the disk is full") << "at the latest when no more pictures may wait";
  EXPECT_EQ(error_of([&] { sink->end(); }), "none");
  EXPECT_EQ(log.indices, (std::vector<long>{0, 1}));
  EXPECT_EQ(log.calls.back(), "end");
}

TEST(OnThread, AFailureOfTheLastPictureIsToldByTheEnd) {
  Log log;
  log.on_image = [](long) { throw std::runtime_error("the disk is full"); };
  const auto sink = on_thread(std::make_unique<Noting>(log));
  sink->begin(named("a"), 1, 1);
  hand(*sink, 0);
  EXPECT_EQ(error_of([&] { sink->end(); }), "the disk is full");
  EXPECT_EQ(log.calls.back(), "end");
}
