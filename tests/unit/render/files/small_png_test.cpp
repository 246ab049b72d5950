#include "render/files/small_png.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "render/outputs.hpp"
#include "tests/unit/render/read_png.hpp"
#include "tests/unit/render/scratch.hpp"

namespace seiche::render {
namespace {

Image chequered(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<std::uint8_t>((x * 7919 + y * 104729) % 251);
      image.rgba.insert(image.rgba.end(), {value, value, value, 255});
    }
  return image;
}

TEST(SmallPng, EachPixelIsTheMeanOfWhatItCovers) {
  const Image two{4, 2, {0,  0, 0, 255, 100, 0, 0, 255, 8, 8, 8, 255, 8, 8, 8, 255,  //
                         40, 0, 0, 255, 20,  0, 0, 255, 8, 8, 8, 255, 8, 8, 8, 255}};
  const Image one = shrunk(two, 2);
  EXPECT_EQ(one.height, 1);
  EXPECT_EQ(one.rgba, (std::vector<std::uint8_t>{40, 0, 0, 255, 8, 8, 8, 255}));
}

TEST(SmallPng, PartsOfPixelsCountAsParts) {
  const Image three{3, 1, {0, 0, 0, 255, 90, 0, 0, 255, 180, 0, 0, 255}};
  const Image two = shrunk(three, 2);
  EXPECT_EQ(two.rgba[0], 30) << "one and a half pixels: (0 + 45) / 1.5";
  EXPECT_EQ(two.rgba[4], 150);
}

TEST(SmallPng, WhatCannotBeSeenHasNoColour) {
  const Image two{2, 1, {200, 0, 0, 255, 0, 255, 0, 0}};
  EXPECT_EQ(shrunk(two, 1).rgba, (std::vector<std::uint8_t>{200, 0, 0, 128}));
}

TEST(SmallPng, IsTheFileItselfWhereThatIsSmallEnough) {
  const test::Scratch scratch;
  write_png(scratch / "a.png", chequered(640, 360), {{"Title", "kept"}});
  const auto size = std::filesystem::file_size(scratch / "a.png");
  const std::string whole = small_png(scratch / "a.png", size);
  EXPECT_EQ(whole.size(), size);
  const std::string small = small_png(scratch / "a.png", size / 2);
  EXPECT_LE(small.size(), size / 2);
  std::ofstream(scratch / "b.png", std::ios::binary) << small;
  const Image image = test::read_png(scratch / "b.png");
  EXPECT_LT(image.width, 640);
  EXPECT_NEAR(image.height, image.width * 360.0 / 640, 0.51);
}

TEST(SmallPng, NamesAFileThatCannotBeRead) {
  const test::Scratch scratch;
  std::ofstream(scratch / "a.png") << "not a picture";
  EXPECT_THROW(small_png(scratch / "a.png", 5), std::runtime_error);
  EXPECT_THROW(small_png(scratch / "none.png", 5), std::runtime_error);
}

}  // namespace
}  // namespace seiche::render
