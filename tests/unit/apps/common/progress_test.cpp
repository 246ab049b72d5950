#include "apps/common/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace seiche::apps {
namespace {

const Moment half{5, 10, 250, 500, 1200, 60, false};

TEST(Progress, ClockShowsHoursOnlyWhenThereAreSome) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(65.4), "1:05");
  EXPECT_EQ(clock_text(2 * 3600 + 3 * 60 + 4), "2:03:04");
}

TEST(Progress, ALineTellsShareTimeFrameStepsRateAndWhatIsLeft) {
  EXPECT_EQ(progress_line(half), " 50 %  5.00/10 s  frame 250/500  1200 steps  20 steps/s  1:00 left");
}

TEST(Progress, AReplayCountsPicturesFromWhereItBegan) {
  const Moment replay{7.5, 10, 375, 500, 125, 5, false, 5, "pictures"};
  EXPECT_EQ(progress_line(replay), " 50 %  7.50/10 s  frame 375/500  125 pictures  25 pictures/s  0:05 left");
  const Moment one{5, 5, 250, 250, 1, 1, false, 5, "pictures"};
  EXPECT_EQ(progress_line(one), "100 %  5.00/5 s  frame 250/250  1 pictures  1 pictures/s  0:00 left");
}

TEST(Progress, TheBarFillsWithTheShare) {
  EXPECT_EQ(progress_bar(half, 200).substr(0, 19), "[#####-----]  50 % ");
  Moment end = half;
  end.time = end.end;
  EXPECT_EQ(progress_bar(end, 200).substr(0, 19), "[##########] 100 % ");
}

TEST(Progress, TheBarStaysWithinTheTerminal) { EXPECT_EQ(progress_bar(half, 40).size(), 39u); }

TEST(Progress, NothingIsForetoldTooEarly) {
  EXPECT_EQ(progress_line({0.01, 10, 0, 500, 1, 3, false}), "  0 %  0.01/10 s  frame 0/500  1 steps  0.333 steps/s  ");
}

TEST(Progress, ASignalIsAcknowledged) {
  Moment stopping = half;
  stopping.stopping = true;
  EXPECT_NE(progress_line(stopping).find("ending with this frame"), std::string::npos);
}

TEST(Progress, ALogGetsOneLineForEachTwentieth) {
  testing::internal::CaptureStdout();
  Progress progress(Progress::Style::lines);
  for (int i = 1; i <= 1000; ++i) progress.show({i * 0.01, 10, i / 2, 500, i, i * 0.1, false});
  const std::string log = testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 21);
}

TEST(Progress, ARestSaysHowManyFramesWait) {
  EXPECT_EQ(rest_line(3), "steps done; 3 frames to draw and write");
  EXPECT_EQ(rest_line(1), "steps done; 1 frame to draw and write");
  EXPECT_EQ(rest_line(0), "steps done; finishing the outputs");
}

TEST(Progress, ALogHearsOfARestOnceAndOnlyIfItLasts) {
  testing::internal::CaptureStdout();
  Progress progress(Progress::Style::lines);
  for (int i = 1; i < 50; ++i) progress.show_rest(3, i * 0.1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), rest_line(3) + "\n");
  testing::internal::CaptureStdout();
  Progress(Progress::Style::lines).show_rest(3, 0.1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Progress, QuietShowsNothing) {
  testing::internal::CaptureStdout();
  Progress progress(Progress::Style::none);
  progress.show(half);
  progress.show_rest(3, 5);
  progress.clear();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace seiche::apps
