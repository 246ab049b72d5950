#include "apps/run/frame_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <future>
#include <latch>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace seiche::apps {
namespace {

constexpr double long_enough = 30;  // [s], for what takes no time

// Notes what it is given, and who calls; `on_frame` may wait or throw.
struct Log {
  std::vector<long> frames;
  int begins = 0, ends = 0;
  std::vector<std::thread::id> threads;
  std::function<void(long)> on_frame = [](long) {};
  std::string begin_fails, end_fails;
};
class Noting : public Sink {
 public:
  explicit Noting(Log& log) : log_(log) {}
  ~Noting() override { note(); }
  void begin(const RunInfo&) override {
    note();
    ++log_.begins;
    if (!log_.begin_fails.empty()) throw std::runtime_error(log_.begin_fails);
  }
  void frame(const FramePtr& frame) override {
    note();
    log_.on_frame(frame->index);
    log_.frames.push_back(frame->index);
  }
  void end() override {
    note();
    ++log_.ends;
    if (!log_.end_fails.empty()) throw std::runtime_error(log_.end_fails);
  }

 private:
  void note() { log_.threads.push_back(std::this_thread::get_id()); }
  Log& log_;
};

FramePtr numbered(long index) {
  auto frame = std::make_shared<Frame>();
  frame->index = index;
  return frame;
}

std::vector<long> up_to(long count) {
  std::vector<long> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

struct FrameQueueTest : testing::Test {
  FrameQueueTest() { outputs.add("log", std::make_unique<Noting>(log)); }
  void push(FrameQueue& queue, long from, long to) {
    for (long k = from; k < to; ++k) queue.push(numbered(k));
  }
  RunInfo run;
  Log log;
  Outputs outputs;
};

TEST_F(FrameQueueTest, KeepsTheOrderAndEndsOnce) {
  FrameQueue queue(outputs, run);
  push(queue, 0, 100);
  queue.close();
  ASSERT_TRUE(queue.ended_within(long_enough));
  EXPECT_EQ(log.frames, up_to(100));
  EXPECT_EQ(queue.taken(), 100);
  EXPECT_EQ(queue.error(), "");
  EXPECT_EQ(log.begins, 1);
  EXPECT_EQ(log.ends, 1);
}

TEST_F(FrameQueueTest, OutputsLiveAndDieOnOneThreadOfTheirOwn) {
  {
    FrameQueue queue(outputs, run);
    push(queue, 0, 3);
  }
  ASSERT_EQ(log.threads.size(), 1u + 3 + 1 + 1) << "begin, frames, end, destructor";
  for (const std::thread::id id : log.threads) {
    EXPECT_EQ(id, log.threads.front());
    EXPECT_NE(id, std::this_thread::get_id());
  }
}

TEST_F(FrameQueueTest, WaitsWhileFull) {
  std::latch gate(1);
  std::atomic<long> handed_on = 0;
  log.on_frame = [&](long k) {
    if (k == 0) gate.wait();
  };
  const long fit = FrameQueue::depth + 1;  // one of them with the outputs
  FrameQueue queue(outputs, run);
  auto producer = std::async(std::launch::async, [&] {
    for (long k = 0; k <= fit; ++k) {
      queue.push(numbered(k));
      ++handed_on;
      handed_on.notify_all();
    }
  });
  for (long seen = handed_on; seen < fit; seen = handed_on) handed_on.wait(seen);
  EXPECT_EQ(producer.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout) << "the last one waits";
  EXPECT_EQ(handed_on, fit);
  EXPECT_EQ(queue.waiting(), FrameQueue::depth);
  gate.count_down();
  producer.get();
  EXPECT_GE(queue.waited(), 0.04);
  queue.close();
  ASSERT_TRUE(queue.ended_within(long_enough));
  EXPECT_EQ(log.frames, up_to(fit + 1));
}

TEST_F(FrameQueueTest, AFailureLetsAWaitingProducerGoAndDropsWhatWaits) {
  log.on_frame = [](long k) {
    if (k == 2) throw std::runtime_error("the disk is full");
  };
  FrameQueue queue(outputs, run);
  push(queue, 0, 50);
  ASSERT_TRUE(queue.ended_within(long_enough)) << "without a close()";
  EXPECT_TRUE(queue.failed());
  EXPECT_EQ(queue.error(), "the disk is full");
  EXPECT_EQ(queue.taken(), 2);
  EXPECT_EQ(queue.waiting(), 0u);
  EXPECT_EQ(log.frames, up_to(2));
  EXPECT_EQ(log.ends, 1);
}

TEST_F(FrameQueueTest, AFailureToBeginTakesNoFrame) {
  log.begin_fails = "no OpenGL";
  FrameQueue queue(outputs, run);
  push(queue, 0, 50);
  ASSERT_TRUE(queue.ended_within(long_enough));
  EXPECT_EQ(queue.error(), "no OpenGL");
  EXPECT_EQ(queue.taken(), 0);
  EXPECT_TRUE(log.frames.empty());
  EXPECT_EQ(log.ends, 0) << "it never began";
}

TEST_F(FrameQueueTest, AFailureToEndIsTold) {
  log.end_fails = "ffmpeg was killed";
  FrameQueue queue(outputs, run);
  push(queue, 0, 2);
  queue.close();
  ASSERT_TRUE(queue.ended_within(long_enough));
  EXPECT_EQ(queue.error(), "ffmpeg was killed");
  EXPECT_EQ(queue.taken(), 2);
}

}  // namespace
}  // namespace seiche::apps
