#include "render/files/frame_spool.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <stdexcept>

#include "tests/unit/render/expect_same_frame.hpp"
#include "tests/unit/render/scratch.hpp"

using namespace seiche;
using render::FrameSpool;

namespace {

Frame sample(long index, std::size_t particles) {
  Frame frame;
  frame.index = index;
  frame.step = 17 * index;
  frame.time = 0.1 * static_cast<double>(index);
  frame.pose.displacement = {0.1, 0.2, 0.3};
  frame.pose.orientation = Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitX());
  frame.pose.pivot = {0.4, 0.5, 0.6};
  for (std::size_t i = 0; i < particles; ++i) {
    const auto value = static_cast<float>(i) / 3 + static_cast<float>(index);
    frame.position.push_back({value, value + 1, value + 2});
    frame.velocity.push_back({-value, 0, value});
    frame.pressure.push_back(100 * value);
    frame.number_density.push_back(1 + value / 100);
    frame.kind.push_back(static_cast<Kind>(i % 3));
    frame.free_surface.push_back(i % 2 == 0);
    frame.id.push_back(static_cast<std::uint32_t>(i));
  }
  frame.derived.push_back({Quantity::vorticity, std::vector<float>(particles, static_cast<float>(index))});
  frame.readings = {{0.01, 0.02}, {1.5, 2.5, 3.5, 4.5}};
  return frame;
}

void expect_same(const Frame& a, const Frame& b) {
  test::expect_same_frame(a, b);
  EXPECT_EQ(a.readings.time, b.readings.time);
  EXPECT_EQ(a.readings.values, b.readings.values);
}

// No file may grow beyond this while it lives: like a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t most) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{most, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace

TEST(FrameSpool, FramesComeBackAsTheyWere) {
  const test::Scratch scratch;
  FrameSpool spool(scratch / "new" / "folder");
  const std::vector<Frame> frames{sample(0, 5), sample(1, 0), sample(2, 1000), sample(7, 6)};
  for (const Frame& frame : frames) spool.write(frame);
  for (const Frame& frame : frames) {
    const auto back = spool.read();
    ASSERT_TRUE(back);
    expect_same(*back, frame);
  }
  EXPECT_FALSE(spool.read());
}

TEST(FrameSpool, LeavesNoFileInTheFolder) {
  const test::Scratch scratch;
  FrameSpool spool(scratch.folder());
  spool.write(sample(0, 5));
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder()));
}

TEST(FrameSpool, AFullDiskIsSaidAndLosesNoneBefore) {
  const test::Scratch scratch;
  FrameSpool spool(scratch.folder());
  spool.write(sample(0, 5));
  {
    const FullDisk full(4096);
    try {
      spool.write(sample(1, 1000));
      ADD_FAILURE() << "written";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(scratch.folder().string()), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("File too large"), std::string::npos) << error.what();
    }
  }
  spool.write(sample(2, 3));
  expect_same(*spool.read(), sample(0, 5));
  expect_same(*spool.read(), sample(2, 3));
  EXPECT_FALSE(spool.read());
}

TEST(FrameSpool, AFolderThatCannotBeMadeIsSaid) {
  const test::Scratch scratch;
  std::ofstream(scratch / "file") << "no folder";
  EXPECT_THROW(FrameSpool(scratch / "file"), std::runtime_error);
}
