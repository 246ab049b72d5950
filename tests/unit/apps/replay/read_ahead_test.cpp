#include "apps/replay/read_ahead.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <memory>
#include <stdexcept>

namespace seiche::apps {
namespace {

using Number = std::shared_ptr<const long>;

// 0, 1, 2 ... up to `count` of them.
ReadAhead<Number>::Make counting(long count, std::atomic<long>& made) {
  return [count, &made](const std::stop_token&) -> Number {
    if (made == count) return {};
    return std::make_shared<const long>(made++);
  };
}

TEST(ReadAhead, HandsOutAllInOrderAndThenNothing) {
  std::atomic<long> made = 0;
  ReadAhead<Number> ahead(counting(100, made), 3);
  for (long k = 0; k < 100; ++k) EXPECT_EQ(*ahead.next(), k);
  EXPECT_FALSE(ahead.next());
  EXPECT_FALSE(ahead.next());
}

TEST(ReadAhead, IsNeverFurtherAheadThanItMayBe) {
  std::atomic<long> made = 0;
  ReadAhead<Number> ahead(
      [&](const std::stop_token&) {
        ++made;
        return std::make_shared<const long>(made);
      },
      3);
  for (long taken = 1; taken < 200; ++taken) {
    ahead.next();
    EXPECT_LE(made, taken + 3);
  }
}

TEST(ReadAhead, AnErrorComesAfterWhatWasMadeBeforeIt) {
  long made = 0;
  ReadAhead<Number> ahead(
      [&](const std::stop_token&) -> Number {
        if (made == 2) throw std::runtime_error("damaged");
        return std::make_shared<const long>(made++);
      },
      5);
  EXPECT_EQ(*ahead.next(), 0);
  EXPECT_EQ(*ahead.next(), 1);
  EXPECT_THROW(ahead.next(), std::runtime_error);
  EXPECT_FALSE(ahead.next()) << "told once";
}

TEST(ReadAhead, WhoeverWaitsForMoreIsToldWhenNobodyTakesIt) {
  std::latch waiting(1);
  bool told = false;
  {
    ReadAhead<Number> ahead(
        [&](const std::stop_token& stop) -> Number {
          std::latch asked(1);
          const std::stop_callback when(stop, [&] { asked.count_down(); });
          waiting.count_down();
          asked.wait();
          told = stop.stop_requested();
          return {};
        },
        3);
    waiting.wait();
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace seiche::apps
