#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <fstream>
#include <map>

#include "render/outputs.hpp"
#include "tests/unit/render/read_png.hpp"
#include "tests/unit/render/scratch.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

// A few pixels of every kind.
Image pattern(std::uint8_t alpha) {
  Image image{5, 3, {}};
  for (int i = 0; i < 15; ++i) {
    const auto value = static_cast<std::uint8_t>(17 * i);
    image.rgba.insert(image.rgba.end(),
                      {value, static_cast<std::uint8_t>(255 - value), 90, i == 7 ? alpha : std::uint8_t{255}});
  }
  return image;
}

std::map<std::string, std::string> text_chunks(const std::filesystem::path& file) {
  std::FILE* in = std::fopen(file.c_str(), "rb");
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, in);
  png_read_info(png, info);
  png_textp chunks = nullptr;
  const int count = png_get_text(png, info, &chunks, nullptr);
  std::map<std::string, std::string> text;
  for (int i = 0; i < count; ++i) text[chunks[i].key] = chunks[i].text;
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(in);
  return text;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(Png, KeepsEveryPixel) {
  const test::Scratch scratch;
  for (const int alpha : {255, 0, 128}) {
    const Image image = pattern(static_cast<std::uint8_t>(alpha));
    write_png(scratch / "a.png", image, {});
    const Image read = test::read_png(scratch / "a.png");
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.rgba, image.rgba) << "alpha " << alpha;
  }
}

TEST(Png, KeepsTextAlsoBeyondAscii) {
  const test::Scratch scratch;
  write_png(scratch / "a.png", pattern(255), {{"Title", "seiche"}, {"Parameters", "a = 1\n\"l\u2080\" = 2"}});
  const auto text = text_chunks(scratch / "a.png");
  EXPECT_EQ(text.at("Title"), "seiche");
  EXPECT_EQ(text.at("Parameters"), "a = 1\n\"l\u2080\" = 2");
}

TEST(Png, SeriesIsNumberedByFrameAndSaysWhereItComesFrom) {
  const test::Scratch scratch;
  auto run = test::run_info({});
  run.parameters = "spacing = 0.005\n";
  const auto series = png_series(scratch / "frames");
  series->begin(run, 5, 3);
  Frame frame;
  frame.index = 123;
  frame.step = 4567;
  frame.time = 2.46;
  series->image(pattern(255), frame);
  series->end();
  const auto text = text_chunks(scratch / "frames/000123.png");
  EXPECT_EQ(text.at("Software"), "Seiche 0.1.0");
  EXPECT_EQ(text.at("Title"), "pan2008");
  EXPECT_EQ(text.at("Scene hash"), run.scene_hash);
  EXPECT_EQ(text.at("Parameters"), run.parameters);
  EXPECT_EQ(text.at("Time"), "2.46 s");
  EXPECT_EQ(text.at("Step"), "4567");
}

TEST(Png, SamePictureSameBytesAndNothingElseIsLeft) {
  const test::Scratch scratch;
  write_png(scratch / "a.png", pattern(255), {{"Title", "x"}});
  write_png(scratch / "b.png", pattern(255), {{"Title", "x"}});
  EXPECT_EQ(bytes_of(scratch / "a.png"), bytes_of(scratch / "b.png"));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.folder())) files += entry.exists();
  EXPECT_EQ(files, 2);
}

TEST(Png, SaysWhichFileCannotBeWritten) {
  const test::Scratch scratch;
  std::ofstream(scratch / "file") << "in the way";
  try {
    write_png(scratch / "file/a.png", pattern(255), {});
    FAIL() << "written into a file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos) << error.what();
  }
}
