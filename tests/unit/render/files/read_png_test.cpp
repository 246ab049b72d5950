#include "render/files/read_png.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "render/outputs.hpp"
#include "tests/facts.hpp"
#include "tests/unit/render/scratch.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

std::string error_with(const std::filesystem::path& file) {
  try {
    read_png(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(ReadPng, SaysWhichFileIsMissingOrDamaged) {
  const test::Scratch scratch;
  const auto file = scratch / "a.png";
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "can't be read"}));
  std::ofstream(file) << "hello";
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "can't be read"}));

  Image image{64, 64, {}};
  for (unsigned i = 0; i < 4 * 64 * 64; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * i * 31 / 7));
  write_png(file, image, {});
  EXPECT_EQ(error_with(file), "none");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_TRUE(test::tells(error_with(file), {file.string(), "can't be read"}));
}
