#include "render/files/read_vtu.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "render/files/provenance.hpp"
#include "render/files/vtu.hpp"
#include "tests/facts.hpp"
#include "tests/unit/render/expect_same_frame.hpp"
#include "tests/unit/render/scratch.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.length = 0.1, .height = 0.1, .depth = 0.05, .spacing = 0.01};

void write(const std::filesystem::path& file, const Frame& frame) {
  write_vtu(file, frame, provenance(test::run_info(box), frame));
}

std::string error_with(const std::filesystem::path& file) {
  testing::internal::CaptureStderr();
  std::string what = "none";
  try {
    read_vtu(file, 0);
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "VTK has a say of its own";
  return what;
}

}  // namespace

TEST(ReadVtu, GivesTheFrameThatWasWrittenBitByBit) {
  const test::Scratch scratch;
  Frame frame = *test::lattice(box, 0.1, 7);
  frame.time = 0.1 + 0.2;  // which no few digits hold
  frame.pose.velocity = {1.0 / 3, -2e-300, 0};
  frame.pose.acceleration = {0, 1e-300, 2.0 / 3};
  frame.pose.orientation = Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 2, 3).normalized());
  frame.pose.omega = {0.1, -1.0 / 7, 7};
  frame.pose.alpha = {1.0 / 3, 5, -1};
  frame.pressure[1] = std::numeric_limits<float>::max();
  frame.pressure[2] = std::numeric_limits<float>::denorm_min();
  frame.velocity[3] = {-0.0f, std::numeric_limits<float>::lowest(), 1e-38f};
  frame.number_density[4] = 0.987654f;
  frame.id[5] = 4'000'000'000;
  write(scratch / "a.vtu", frame);
  test::expect_same_frame(read_vtu(scratch / "a.vtu", 7), frame);
  frame.derived.push_back({Quantity::vorticity, std::vector<float>(frame.size(), -0.3f)});
  write(scratch / "a.vtu", frame);
  test::expect_same_frame(read_vtu(scratch / "a.vtu", 7), frame);
}

TEST(ReadVtu, TakesAFrameWithoutParticles) {
  const test::Scratch scratch;
  write(scratch / "a.vtu", Frame{});
  test::expect_same_frame(read_vtu(scratch / "a.vtu", 0), Frame{});
}

TEST(ReadVtu, SaysInOneSentenceWhatIsWrong) {
  const test::Scratch scratch;
  const auto file = scratch / "a.vtu";
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "isn't there"}));

  std::ofstream(file) << "t [s],p\n";
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "damaged"}));

  write(file, *test::lattice(box, 0.1));
  const auto whole = std::filesystem::file_size(file);
  for (const double share : {0.99, 0.9, 0.6, 0.3, 0.1, 0.01, 0.0}) {
    write(file, *test::lattice(box, 0.1));
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
    EXPECT_TRUE(test::tells(error_with(file), {file.string(), "damaged"})) << "after " << share << " of it";
  }
}

TEST(ReadVtu, RefusesAnothersFileByWhatItLacks) {
  const test::Scratch scratch;
  const auto file = scratch / "a.vtu";
  write_vtu(file, *test::lattice(box, 0.1), {});
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "step"}));
}
