#include "render/system/bounded_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>

namespace seiche::render {
namespace {

std::exception_ptr disk_is_full() { return std::make_exception_ptr(std::runtime_error("the disk is full")); }

TEST(BoundedQueue, HandsOnAllInOrderAndThenEnds) {
  BoundedQueue<std::unique_ptr<int>> queue(3);
  std::jthread giver([&] {
    for (int k = 0; k < 1000; ++k) EXPECT_TRUE(queue.push(std::make_unique<int>(k)));
    queue.close();
  });
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(**queue.pop(), k);
  EXPECT_FALSE(queue.pop());
  EXPECT_FALSE(queue.pop());
  EXPECT_NO_THROW(queue.rethrow());
}

TEST(BoundedQueue, WaitsWhileFull) {
  BoundedQueue<int> queue(2);
  std::atomic<int> pushed = 0;
  auto giver = std::async(std::launch::async, [&] {
    for (int k = 0; k < 3; ++k) {
      queue.push(k);
      ++pushed;
      pushed.notify_all();
    }
  });
  for (int seen = pushed; seen < 2; seen = pushed) pushed.wait(seen);
  EXPECT_EQ(giver.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  EXPECT_EQ(pushed, 2);
  EXPECT_EQ(queue.size(), 2u);
  EXPECT_EQ(queue.pop(), 0);
  giver.get();
  EXPECT_EQ(queue.size(), 2u);
}

TEST(BoundedQueue, WaitsWhileEmpty) {
  BoundedQueue<int> queue(2);
  auto image_sink = std::async(std::launch::async, [&] { return queue.pop(); });
  EXPECT_EQ(image_sink.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  queue.push(7);
  EXPECT_EQ(image_sink.get(), 7);
}

TEST(BoundedQueue, AnErrorOfTheGiverComesAfterWhatItGave) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.close(disk_is_full());
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_FALSE(queue.pop());
  EXPECT_THROW(queue.rethrow(), std::runtime_error);
  EXPECT_NO_THROW(queue.rethrow()) << "told once";
}

TEST(BoundedQueue, AFailureOfTheTakerLetsAWaitingGiverGoAndDropsWhatWaits) {
  BoundedQueue<int> queue(1);
  queue.push(1);
  auto giver = std::async(std::launch::async, [&] { return queue.push(2); });
  EXPECT_EQ(giver.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  queue.fail(disk_is_full());
  EXPECT_FALSE(giver.get());
  EXPECT_TRUE(queue.failed());
  EXPECT_EQ(queue.size(), 0u);
  EXPECT_FALSE(queue.push(3));
  EXPECT_FALSE(queue.pop());
  EXPECT_THROW(queue.rethrow(), std::runtime_error);
}

}  // namespace
}  // namespace seiche::render
