#include "apps/replay/frame_list.hpp"

#include <gtest/gtest.h>

#include "tests/facts.hpp"
#include "tests/unit/apps/stored_tank.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;

constexpr const char* only_vtu = "output.pictures = false\noutput.movie = \"none\"\n";

std::vector<long> indices_of(FrameList& list) {
  std::vector<long> indices;
  while (const auto next = list.next()) indices.push_back(next->index);
  return indices;
}

Selection frames(const std::string& text) {
  Selection selection;
  select_frames(text, selection);
  return selection;
}

TEST(FrameList, HandsOutWhatIsSelectedByNumberOrTime) {
  const Scratch scratch;
  StoredTank tank(scratch, only_vtu);
  tank.write_frames(5);
  tank.close();
  const StoredRun run = read_run(tank.folder().path);
  const auto selected = [&](const Selection& selection) {
    FrameList list(run, stored_frames, selection);
    return indices_of(list);
  };
  EXPECT_EQ(selected({}), (std::vector<long>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(selected(frames("2:3")), (std::vector<long>{2, 3}));
  EXPECT_EQ(selected(frames("4:")), (std::vector<long>{4, 5}));
  EXPECT_EQ(selected(frames(":1")), (std::vector<long>{0, 1}));
  EXPECT_EQ(selected(frames("3")), (std::vector<long>{3}));
  EXPECT_TRUE(selected(frames("9:")).empty());
  EXPECT_EQ(selected({.from = 0.06, .to = 0.08}), (std::vector<long>{3, 4})) << "both ends, in spite of rounding";
}

TEST(FrameList, WordsThatAreNoFramesAreRefused) {
  for (const char* text : {"", ":", "3:2", "a:b", "1:2:3", "-1:2", "1.5"}) {
    try {
      frames(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_TRUE(test::tells(error.what(), {"'" + std::string(text) + "'", "100:200"}));
    }
  }
}

TEST(FrameList, FollowsARunUntilItHasEnded) {
  const Scratch scratch;
  StoredTank tank(scratch, only_vtu);
  tank.write_frames(1);
  const StoredRun run = read_run(tank.folder().path);
  int waits = 0;
  const auto wait = [&](const std::stop_token&) {
    ++waits;
    if (waits == 2) tank.write_frames(3);
    if (waits == 3) {
      tank.write_frames(4);  // and they are found though the run has ended
      tank.close();
    }
    return true;
  };
  FrameList list(run, stored_frames, {}, wait);
  EXPECT_EQ(list.found().size(), 2u);
  EXPECT_EQ(indices_of(list), (std::vector<long>{0, 1, 2, 3, 4}));
  EXPECT_EQ(waits, 3);
}

TEST(FrameList, GivesUpWhenTold) {
  const Scratch scratch;
  StoredTank tank(scratch, only_vtu);
  tank.write_frames(1);
  const StoredRun run = read_run(tank.folder().path);
  FrameList list(run, stored_frames, {}, [](const std::stop_token&) { return false; });
  EXPECT_EQ(indices_of(list), (std::vector<long>{0, 1}));
}

TEST(FrameList, WithoutPatienceTakesWhatIsThere) {
  const Scratch scratch;
  StoredTank tank(scratch, only_vtu);
  tank.write_frames(1);
  const StoredRun run = read_run(tank.folder().path);
  FrameList list(run, stored_frames, {});
  tank.write_frames(3);
  EXPECT_EQ(indices_of(list), (std::vector<long>{0, 1}));
}

}  // namespace
}  // namespace seiche::apps
