#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numbers>

#include "render/outputs.hpp"
#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.length = 0.2, .height = 0.1, .depth = 0.05, .spacing = 0.01};

// Keeps what it is given where the test can see it.
struct Kept {
  int begun = 0, ended = 0;
  std::vector<Image> images;
  std::vector<long> indices;
};

class Keeper : public ImageSink {
 public:
  explicit Keeper(Kept& kept) : kept_(kept) {}
  void begin(const RunInfo&, int, int) override { ++kept_.begun; }
  void image(const Image& image, const Frame& frame) override {
    kept_.images.push_back(image);
    kept_.indices.push_back(frame.index);
  }
  void end() override { ++kept_.ended; }

 private:
  Kept& kept_;
};

Look small() {
  Look look;
  look.width = 480;
  look.height = 270;
  return look;
}

Kept draw(const Look& look, const std::vector<FramePtr>& frames, const test::Box& tank = box) {
  Kept kept;
  std::vector<std::unique_ptr<ImageSink>> image_sinks;
  image_sinks.push_back(std::make_unique<Keeper>(kept));
  const auto sink = pictures(look, std::move(image_sinks), std::filesystem::temp_directory_path());
  sink->begin(test::run_info(tank));
  for (const auto& frame : frames) sink->frame(frame);
  sink->end();
  return kept;
}

int count(const Image& image, std::array<int, 4> rgba, int within = 0) {
  int found = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    bool same = true;
    for (std::size_t c = 0; c < 4; ++c) same = same && std::abs(image.rgba[i + c] - rgba[c]) <= within;
    found += same;
  }
  return found;
}

// A frame with all pressures times `factor`.
FramePtr scaled(float factor, long index) {
  auto frame = std::make_shared<Frame>(*test::lattice(box, 0, index));
  for (float& pressure : frame->pressure) pressure *= factor;
  return frame;
}

}  // namespace

TEST(Gl, IsOsmesasWithoutADisplay) {
  unsetenv("DISPLAY");
  const std::string text = gl_description();
  EXPECT_NE(text.find("llvmpipe"), std::string::npos) << text;
  EXPECT_NE(text.find("through OSMesa"), std::string::npos) << text;
}

TEST(GlDeathTest, TooOldNamesThePackage) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // Mesa asks the environment once in a process
  const auto ask = [] {
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    try {
      gl_description();
    } catch (const NoGl& error) {
      std::cerr << error.what();
      std::exit(4);
    }
    std::exit(0);
  };
  EXPECT_EXIT(ask(), testing::ExitedWithCode(4), "libosmesa6");
}

TEST(Pictures, EverySinkGetsEachFrameOnceAndTheSame) {
  Kept first, second;
  std::vector<std::unique_ptr<ImageSink>> image_sinks;
  image_sinks.push_back(std::make_unique<Keeper>(first));
  image_sinks.push_back(std::make_unique<Keeper>(second));
  const auto sink = pictures(small(), std::move(image_sinks), std::filesystem::temp_directory_path());
  sink->begin(test::run_info(box));
  for (long index = 0; index < 3; ++index) sink->frame(test::lattice(box, 0.1, index));
  sink->end();
  EXPECT_EQ(first.indices, (std::vector<long>{0, 1, 2}));
  EXPECT_EQ(second.indices, first.indices);
  EXPECT_EQ(first.begun, 1);
  EXPECT_EQ(first.ended, 1);
  ASSERT_EQ(first.images.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(first.images[i].rgba, second.images[i].rgba);
}

TEST(Pictures, ASinkThatFailsAtTheEndKeepsNoOtherFromEnding) {
  struct Failing : ImageSink {
    void begin(const RunInfo&, int, int) override {}
    void image(const Image&, const Frame&) override {}
    void end() override { throw std::runtime_error("the disk is full"); }
  };
  Kept kept;
  std::vector<std::unique_ptr<ImageSink>> image_sinks;
  image_sinks.push_back(std::make_unique<Failing>());
  image_sinks.push_back(std::make_unique<Keeper>(kept));
  const auto sink = pictures(small(), std::move(image_sinks), std::filesystem::temp_directory_path());
  sink->begin(test::run_info(box));
  EXPECT_THROW(sink->end(), std::runtime_error);
  EXPECT_EQ(kept.ended, 1);
}

TEST(Pictures, HaveTheSizeAndTheBackground) {
  Look look = small();
  const auto corner = [&](Background background) {
    look.background = background;
    const Image image = draw(look, {test::lattice(box, 0)}).images.at(0);
    EXPECT_EQ(image.width, 480);
    EXPECT_EQ(image.height, 270);
    EXPECT_EQ(image.rgba.size(), 480u * 270u * 4u);
    return std::vector<int>(image.rgba.begin(), image.rgba.begin() + 4);
  };
  EXPECT_EQ(corner(Background::white), (std::vector<int>{255, 255, 255, 255}));
  EXPECT_EQ(corner(Background::black), (std::vector<int>{0, 0, 0, 255}));
  EXPECT_EQ(corner(Background::transparent)[3], 0);
}

TEST(Pictures, SameFrameSameBytes) {
  const auto frame = test::lattice(box, 0.1, 3);
  EXPECT_EQ(draw(small(), {frame}).images.at(0).rgba,
            draw(small(), {test::lattice(box, 0, 1), frame}).images.at(1).rgba)
      << "a picture doesn't depend on the one before";
}

TEST(Pictures, FreeSurfaceIsMarkedAtEverySpacing) {
  for (const double spacing : {0.01, 0.005, 0.001}) {
    test::Box tank = box;
    tank.spacing = spacing;
    Look look = small();
    const auto frame = test::lattice(tank, 0);
    const auto marks = [&] { return count(draw(look, {frame}, tank).images.at(0), {255, 88, 24, 255}, 90); };
    const int with = marks();
    look.show_surface = false;
    EXPECT_GT(with, marks() + 250) << "at a spacing of " << spacing;  // the surface is about 350 pixels long
  }
}

TEST(Pictures, FixedRangesDrawHalfThePressureInAnotherColourAndTheFramesOwnDoesNot) {
  Look look = small();
  look.show_bar = look.show_clock = look.show_surface = false;
  const std::vector<FramePtr> frames{scaled(1, 0), scaled(0.5f, 1)};
  for (const char* range : {"scene", "0,1000"}) {
    look.range = parse_range(range);
    const auto drawn = draw(look, frames).images;
    EXPECT_NE(drawn.at(0).rgba, drawn.at(1).rgba) << range;
  }
  look.range = parse_range("frame");
  const std::vector<FramePtr> powers{scaled(1, 0), scaled(0.1f, 1)};  // whose round ranges are alike as well
  const auto drawn = draw(look, powers).images;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < drawn.at(0).rgba.size(); ++i) apart += std::abs(drawn[0].rgba[i] - drawn[1].rgba[i]) > 3;
  EXPECT_EQ(apart, 0u);
}

TEST(Pictures, RunRangeIsDrawnAtTheEndWithOneRangeForAll) {
  Look look = small();
  look.show_clock = false;
  look.range = parse_range("run");
  const auto frames = {scaled(0.1f, 0), scaled(1, 1)};
  const Kept run = draw(look, frames);
  ASSERT_EQ(run.images.size(), 2u);
  EXPECT_EQ(run.indices, (std::vector<long>{0, 1}));
  look.range = parse_range("0,500");  // from 5 to 441 Pa, rounded
  const Kept fixed = draw(look, frames);
  EXPECT_EQ(run.images[0].rgba, fixed.images[0].rgba);
  EXPECT_EQ(run.images[1].rgba, fixed.images[1].rgba);
  look.range = parse_range("frame");
  EXPECT_NE(draw(look, frames).images[0].rgba, run.images[0].rgba) << "its own range differs where pressures are small";
}

TEST(Pictures, SmoothLiquidLeavesNoSprayOut) {
  Look look = small();
  look.style = Style::smooth;
  const auto still = test::lattice(box, 0);
  auto sprayed = std::make_shared<Frame>(*still);
  const auto fluid = std::find(still->kind.begin(), still->kind.end(), Kind::fluid) - still->kind.begin();
  sprayed->position[static_cast<std::size_t>(fluid)] = {0.1f, 0.085f, 0};
  sprayed->pressure[static_cast<std::size_t>(fluid)] = 1e6;  // the end of the colours
  const std::array<int, 4> yellow{253, 231, 37, 255};
  const auto drawn = draw(look, {still, sprayed}).images;
  EXPECT_GT(count(drawn.at(1), yellow, 4), count(drawn.at(0), yellow, 4) + 50);
}

TEST(Pictures, TwoSeriesMayBeDrawnInTurns) {
  Look black = small();
  black.background = Background::black;
  black.width = 640;
  const auto run = test::run_info(box);
  Painter first(run, small()), second(run, black);
  const auto frame = test::lattice(box, 0.1);
  const Image white = first.draw(*frame, {0, 500});
  const Image dark = second.draw(*frame, {0, 500});
  EXPECT_NE(white.rgba, dark.rgba);
  EXPECT_EQ(first.draw(*frame, {0, 500}).rgba, white.rgba);
  EXPECT_EQ(second.draw(*frame, {0, 500}).rgba, dark.rgba);
}

TEST(Pictures, PartsCanBeHidden) {
  const auto frame = test::lattice(box, 0.1);
  const Image all = draw(small(), {frame}).images.at(0);
  for (bool Look::*part : {&Look::show_walls, &Look::show_surface, &Look::show_tank, &Look::show_bar, &Look::show_clock,
                           &Look::show_caption, &Look::show_ruler}) {
    Look look = small();
    look.*part = false;
    EXPECT_NE(draw(look, {frame}).images.at(0).rgba, all.rgba);
  }
}

TEST(Pictures, TankMovesInTheLabAndStandsInItsOwnFrame) {
  Look look = small();
  look.show_clock = false;
  auto moved = std::make_shared<Frame>(*test::lattice(box, 0.1));
  moved->pose.displacement = {0.015, 0, 0};
  const std::vector<FramePtr> frames{test::lattice(box, 0.1), moved};
  auto drawn = draw(look, frames).images;
  EXPECT_EQ(drawn.at(0).rgba, drawn.at(1).rgba);
  look.view = ReferenceFrame::lab;
  drawn = draw(look, frames).images;
  EXPECT_NE(drawn.at(0).rgba, drawn.at(1).rgba);
  const std::array<int, 4> wall{128, 132, 138, 255};
  EXPECT_NEAR(count(drawn.at(0), wall, 2), count(drawn.at(1), wall, 2), 0.1 * count(drawn.at(0), wall, 2) + 100)
      << "nothing of the tank is cut off";
}

TEST(Pictures, TankRollsInTheLabAboutItsPivot) {
  Look look = small();
  look.show_clock = false;
  auto rolled = std::make_shared<Frame>(*test::lattice(box, 0));
  rolled->pose.orientation = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ());
  rolled->pose.pivot = {box.length / 2, box.height / 2, 0};
  auto raised = std::make_shared<Frame>(*test::lattice(box, 0));
  raised->pose.displacement = {0, box.spacing, 0};
  const std::vector<FramePtr> frames{test::lattice(box, 0), rolled, raised};
  auto drawn = draw(look, frames).images;
  EXPECT_EQ(drawn.at(0).rgba, drawn.at(1).rgba) << "nothing turns in the tank's own frame";
  look.view = ReferenceFrame::lab;
  drawn = draw(look, frames).images;
  // Upside down about its middle the closed tank covers what it covered, and the liquid is at the top.
  const std::array<int, 4> wall{128, 132, 138, 255};
  EXPECT_NEAR(count(drawn.at(0), wall, 2), count(drawn.at(1), wall, 2), 0.1 * count(drawn.at(0), wall, 2) + 100);
  const auto mean_row = [&](const Image& image) {
    double sum = 0, marks = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* pixel = &image.rgba[4 * (y * image.width + x)];
        if (pixel[0] == 255 && pixel[1] == 88 && pixel[2] == 24) sum += y, ++marks;
      }
    return sum / marks;
  };
  // Centres of the free surface lie half a spacing below mid-height, and then half a spacing above it.
  EXPECT_NEAR(mean_row(drawn.at(1)), mean_row(drawn.at(2)), 1);
  EXPECT_NE(drawn.at(0).rgba, drawn.at(1).rgba);
}

TEST(Pictures, TakeFramesWithNanAndWithoutParticles) {
  auto broken = std::make_shared<Frame>(*test::lattice(box, 0));
  broken->pressure[10] = std::numeric_limits<float>::quiet_NaN();
  broken->position[11] = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
  for (const char* range : {"scene", "frame", "run"}) {
    Look look = small();
    look.range = parse_range(range);
    EXPECT_EQ(draw(look, {std::make_shared<Frame>(), broken}).images.size(), 2u) << range;
  }
}

TEST(Curves, EachHasAColourOfItsOwn) {
  std::vector<Curve> curves;
  for (int k = 0; k < 5; ++k) curves.push_back({"KF" + std::to_string(k + 1), {0, 0.5, 1}, {1.0 + k, 0.5 * k, 0}});
  const Image image = draw_curves(curves, "Kernels", "r / re", "w", 640, 360);
  EXPECT_EQ(image.width, 640);
  const std::array<int, 4> colours[] = {
      {0, 114, 178, 255}, {213, 94, 0, 255}, {0, 158, 115, 255}, {204, 121, 167, 255}, {86, 180, 233, 255}};
  for (const auto& colour : colours) EXPECT_GT(count(image, colour, 3), 100) << colour[0];
}
