#include "apps/compare/progress_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace seiche::apps::compare {
namespace {

using State = ProgressRow::State;

std::vector<ProgressRow> rows() {
  return {{.label = "KF1", .state = State::running, .time = 4.1, .end = 10, .ending = {}},
          {.label = "KF2, 5 mm", .state = State::over, .time = 0, .end = 10, .ending = "stopped at 0.019 s: why"},
          {.label = "KF3", .end = 10, .ending = {}}};
}

TEST(ProgressTable, ALineTellsHowFarARunIs) {
  EXPECT_EQ(row_line(rows()[0], 9), "KF1        [####------]  41 %  4.10/10 s");
  EXPECT_EQ(row_line(rows()[1], 9), "KF2, 5 mm  stopped at 0.019 s: why");
  EXPECT_EQ(row_line(rows()[2], 9), "KF3        waiting");
}

TEST(ProgressTable, ARunThatIsOverIsDoneHoweverFarItCame) {
  EXPECT_EQ(share(rows()[1]), 1);
  EXPECT_EQ(total_line(rows(), 9, 83), "total      [####------]  47 %  1 of 3 done, 1:23 so far");
}

TEST(ProgressTable, ALogGetsALineForEachTenthAndForEachEnd) {
  testing::internal::CaptureStdout();
  ProgressTable table(Progress::Style::lines);
  auto all = rows();
  all[1].state = State::waiting;
  for (int k = 0; k <= 100; ++k) {
    all[0].time = 0.1 * k;
    table.show(all, k);
    table.show(all, k);
  }
  all[0].state = State::over;
  all[0].ending = "finished at 10 s";
  table.show(all, 100);
  table.show(all, 101);
  const std::string log = testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 10 + 2) << log;
  EXPECT_NE(log.find("KF1        finished at 10 s\ntotal      [###-------]  33 %  1 of 3 done"), std::string::npos)
      << log;
}

TEST(ProgressTable, QuietSaysNothing) {
  testing::internal::CaptureStdout();
  ProgressTable(Progress::Style::none).show(rows(), 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace seiche::apps::compare
