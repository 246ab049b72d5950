#include "apps/compare/board.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace seiche::apps::compare {
namespace {

using State = Lane::State;

std::vector<Lane> lanes() {
  return {{.label = "KF1", .state = State::running, .time = 4.1, .end = 10, .verdict = {}},
          {.label = "KF2, 5 mm", .state = State::over, .time = 0, .end = 10, .verdict = "stopped at 0.019 s: why"},
          {.label = "KF3", .end = 10, .verdict = {}}};
}

TEST(Board, ALineTellsHowFarARunIs) {
  EXPECT_EQ(lane_line(lanes()[0], 9), "KF1        [####------]  41 %  4.10/10 s");
  EXPECT_EQ(lane_line(lanes()[1], 9), "KF2, 5 mm  stopped at 0.019 s: why");
  EXPECT_EQ(lane_line(lanes()[2], 9), "KF3        waiting");
}

TEST(Board, ARunThatIsOverIsDoneHoweverFarItCame) {
  EXPECT_EQ(share(lanes()[1]), 1);
  EXPECT_EQ(total_line(lanes(), 9, 83), "total      [####------]  47 %  1 of 3 done, 1:23 so far");
}

TEST(Board, ALogGetsALineForEachTenthAndForEachEnd) {
  testing::internal::CaptureStdout();
  Board board(Progress::Style::lines);
  auto all = lanes();
  all[1].state = State::waiting;
  for (int k = 0; k <= 100; ++k) {
    all[0].time = 0.1 * k;
    board.show(all, k);
    board.show(all, k);
  }
  all[0].state = State::over;
  all[0].verdict = "finished at 10 s";
  board.show(all, 100);
  board.show(all, 101);
  const std::string log = testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 10 + 2) << log;
  EXPECT_NE(log.find("KF1        finished at 10 s\ntotal      [###-------]  33 %  1 of 3 done"), std::string::npos)
      << log;
}

TEST(Board, QuietSaysNothing) {
  testing::internal::CaptureStdout();
  Board(Progress::Style::none).show(lanes(), 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace seiche::apps::compare
