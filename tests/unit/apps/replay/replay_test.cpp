#include "apps/replay/replay.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/common/exit_codes.hpp"
#include "apps/run/stored_run.hpp"
#include "render/files/read_png.hpp"
#include "render/files/read_vtu.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/stored_tank.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

using test::Scratch;

// Pixels that differ.
long difference(const fs::path& a, const fs::path& b) {
  const render::Image one = render::read_png(a), two = render::read_png(b);
  EXPECT_EQ(one.rgba.size(), two.rgba.size()) << a << " and " << b;
  long count = 0;
  for (std::size_t i = 0; i < std::min(one.rgba.size(), two.rgba.size()); i += 4)
    count += !std::equal(one.rgba.begin() + static_cast<long>(i), one.rgba.begin() + static_cast<long>(i) + 4,
                         two.rgba.begin() + static_cast<long>(i));
  return count;
}

ReplayRequest asked(const StoredTank& tank, const std::vector<std::string>& sets = {}) {
  ReplayRequest request;
  request.run = tank.folder().path;
  request.quiet = true;
  for (const std::string& set : sets) request.look.push_back(parse_set(set));
  return request;
}

std::string number(long index) { return fmt::format("{:06}.png", index); }

// What the run itself drew, and what is drawn of it now. Readings have seven digits in probes.csv, so that an edge of a
// curve may come to lie on the other side of a pixel's sample, once in many pictures.
void expect_same_pictures(const StoredTank& tank, long last) {
  constexpr long stray = 4;
  for (long index = 0; index <= last; ++index)
    EXPECT_LE(difference(tank.folder().frames() / number(index), tank.folder().drawn_again() / number(index)), stray)
        << index;
}

TEST(Replay, DrawsThePicturesOfTheRunItself) {
  const Scratch scratch;
  for (const char* range : {"scene", "frame", "run", "-50,600"}) {
    StoredTank tank(scratch, fmt::format("[look]\nrange = \"{}\"\nview = \"lab\"\n", range));
    tank.write_frames(5);
    tank.close();
    ASSERT_EQ(replay(asked(tank)), done) << range;
    expect_same_pictures(tank, 5);
    EXPECT_FALSE(fs::exists(tank.folder().drawn_again() / number(6)));
  }
}

TEST(Replay, WithoutCurvesThoseAreTheSameToTheByte) {
  const Scratch scratch;
  StoredTank tank(scratch, "output.probes = false\nlook.curves = \"none\"\n");
  tank.write_frames(2);
  tank.close();
  ASSERT_EQ(replay(asked(tank)), done);
  for (long index = 0; index <= 2; ++index)
    EXPECT_TRUE(test::read_file(tank.folder().frames() / number(index)) ==
                test::read_file(tank.folder().drawn_again() / number(index)))
        << index;
}

TEST(Replay, LooksOtherwiseIfAsked) {
  const Scratch scratch;
  StoredTank tank(scratch);
  tank.write_frames(3);
  tank.close();
  ReplayRequest request = asked(tank, {"look.colour_map=turbo", "output.size=400x300"});
  request.frames.first = 2;
  request.movie = render::MovieFormat::gif;
  ASSERT_EQ(replay(request), done);
  const fs::path folder = tank.folder().drawn_again();
  EXPECT_FALSE(fs::exists(folder / number(1)));
  EXPECT_EQ(render::read_png(folder / number(2)).width, 400);
  EXPECT_TRUE(fs::exists(folder / number(3)));
  EXPECT_TRUE(fs::exists(folder / "tank.gif"));
}

TEST(Replay, ADamagedFrameEndsItAndKeepsWhatIsDrawn) {
  const Scratch scratch;
  StoredTank tank(scratch);
  tank.write_frames(3);
  tank.close();
  test::write_text(stored_frames(read_run(tank.folder().path))[2].file, "oh");
  testing::internal::CaptureStderr();
  EXPECT_EQ(replay(asked(tank)), failed);
  EXPECT_TRUE(test::tells(testing::internal::GetCapturedStderr(), {"tank_000002.vtu", "damaged"}));
  EXPECT_TRUE(fs::exists(tank.folder().drawn_again() / number(1)));
  EXPECT_FALSE(fs::exists(tank.folder().drawn_again() / number(2)));
}

std::string refusal(const ReplayRequest& request, int (*verb)(const ReplayRequest&) = replay) {
  try {
    verb(request);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "taken";
}

TEST(Replay, SaysWhyThereIsNothingToDraw) {
  const Scratch scratch;
  const std::string out = (scratch / "out").string();
  {
    StoredTank tank(scratch, "output.vtu = false\noutput.pictures = false\n");
    tank.write_frames(1);
    EXPECT_TRUE(test::tells(refusal(asked(tank)), {out, "output.vtu = false"}));
    ReplayRequest latest = asked(tank);
    latest.latest = true;
    EXPECT_EQ(refusal(latest), refusal(asked(tank))) << "there never will be";
    EXPECT_EQ(refusal(asked(tank), replay_movie), refusal(asked(tank)));
  }
  StoredTank tank(scratch);
  EXPECT_TRUE(test::tells(refusal(asked(tank)), {out, "--latest"}));
  tank.write_frames(2);
  tank.close();
  ReplayRequest request = asked(tank);
  request.frames.first = 7;
  EXPECT_TRUE(test::tells(refusal(request), {out, "0 to 2", "0 to 0.04 s"}));
  EXPECT_FALSE(fs::exists(tank.folder().drawn_again())) << "nothing is written";
}

TEST(Replay, KeepsTheRunsOwnFilesAndAsksBeforeItReplacesOthers) {
  const Scratch scratch;
  StoredTank tank(scratch);
  tank.write_frames(1);
  tank.close();
  ReplayRequest request = asked(tank);
  request.overwrite = true;
  for (const fs::path& own : {tank.folder().path, tank.folder().frames(), tank.folder().path / "vtu"}) {
    request.output = own;
    EXPECT_TRUE(test::tells(refusal(request), {own.string(), "-o DIR"}));
  }
  EXPECT_EQ(replay(asked(tank)), done);
  EXPECT_TRUE(test::tells(refusal(asked(tank)), {tank.folder().drawn_again().string(), "-o DIR", "--overwrite"}));
  request.output.clear();
  request.frames.last = 0;
  EXPECT_EQ(replay(request), done);
  EXPECT_FALSE(fs::exists(tank.folder().drawn_again() / number(1)));
}

TEST(Replay, AsksForReadingsOnlyWhereThereAreSome) {
  const Scratch scratch;
  StoredTank tank(scratch, "output.probes = false\n");
  tank.write_frames(0);
  tank.close();
  EXPECT_EQ(replay(asked(tank)), done) << "its curves are left out";
  EXPECT_TRUE(test::tells(refusal(asked(tank, {"look.curves=eta_left"})),
                          {tank.folder().path.string(), "curves", "output.probes = false"}));
}

}  // namespace
}  // namespace seiche::apps
