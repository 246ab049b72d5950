#include <gtest/gtest.h>

#include <cstdlib>

#include "render/curves/curve_choice.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

// The curves under a picture, as pixels.
using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.spacing = 0.02};

Look one_curve() {
  Look look;
  look.width = 640;
  look.height = 360;
  look.curves = parse_curves("eta_left");
  look.colour_map = ColourMapName::turbo;  // has nothing of the curve's blue in the rows below the tank
  return look;
}

struct Spot {
  double x = 0, y = 0;
  int pixels = 0;
};

// Where the curve's colour is found below the tank; y from the top.
Spot spot(const Image& image) {
  const Rgb colour = palette(Background::white).curve;
  Spot found;
  for (int y = image.height * 3 / 4; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x);
      bool same = true;
      for (std::size_t c = 0; c < 3; ++c) same = same && std::abs(image.rgba[at + c] - colour[c]) < 30;
      if (!same) continue;
      ++found.pixels;
      found.x += x;
      found.y += y;
    }
  found.x /= std::max(found.pixels, 1);
  found.y /= std::max(found.pixels, 1);
  return found;
}

Image draw(const Look& look, double time, const Readings& readings) {
  const RunInfo run = test::run_with_sensors(box);
  Painter painter(run, look);
  Frame frame = *test::lattice(box, 0);
  frame.time = time;
  painter.record(readings);
  return painter.draw(frame, scene_range(run));
}

// Where the dot of a single reading is drawn.
Spot dot(double time, double elevation) { return spot(draw(one_curve(), time, {{time}, {1962, elevation, 0, 0}})); }

}  // namespace

TEST(CurveStrip, TheDotStandsAtTheReading) {
  const Spot low = dot(0, -0.04), middle = dot(0, 0), high = dot(0, 0.04);  // the axis goes from -0.05 to 0.05 m
  ASSERT_GT(middle.pixels, 5);
  EXPECT_GT(low.y - high.y, 30);
  EXPECT_NEAR(middle.y, (low.y + high.y) / 2, 0.6);
  EXPECT_NEAR(low.x, high.x, 0.6);
  const Spot half = dot(5, 0), end = dot(10, 0);
  EXPECT_NEAR(half.x, (middle.x + end.x) / 2, 0.6);
  EXPECT_GT(end.x - middle.x, 480);
}

TEST(CurveStrip, ShowReadingsUpToTheFramesTimeOnly) {
  const Readings all = test::readings(0, 9.9);
  const int early = spot(draw(one_curve(), 2, all)).pixels, late = spot(draw(one_curve(), 8, all)).pixels;
  EXPECT_GT(late, 2 * early);
}

TEST(CurveStrip, AreTheSameWhetherReadingsComeAtOnceOrBitByBit) {
  const RunInfo run = test::run_with_sensors(box);
  Painter painter(run, one_curve());
  Image image;
  for (long index = 0; index < 4; ++index) {
    const auto frame = test::lattice(box, 0, index);
    painter.record(test::readings(index == 0 ? 0 : frame->time - 0.01, frame->time));
    image = painter.draw(*frame, scene_range(run));
  }
  EXPECT_EQ(image.rgba, draw(one_curve(), 0.06, test::readings(0, 0.06)).rgba);
}

TEST(CurveStrip, NoneLeavesThePictureAsItIsWithoutSensors) {
  Look look = one_curve();
  look.curves.emplace();
  const auto frame = test::lattice(box, 0);
  const RunInfo run = test::run_info(box);
  EXPECT_EQ(draw(look, 0, test::readings(0, 0)).rgba, Painter(run, Look(look)).draw(*frame, scene_range(run)).rgba);
}

TEST(CurveStrip, AReferenceIsDrawnForTheWholeRunFromTheFirstFrameOn) {
  Look look = one_curve();
  const auto dark = [](const Image& image) {
    int right = 0;
    for (int y = image.height * 3 / 4; y < image.height * 9 / 10; ++y)
      for (int x = image.width / 2; x < image.width; ++x)
        right += image.rgba[4 * static_cast<std::size_t>(y * image.width + x)] < 120;
    return right;
  };
  const int without = dark(draw(look, 0, test::readings(0, 0)));
  look.references = {test::reference()};
  EXPECT_GT(dark(draw(look, 0, test::readings(0, 0))), without + 100);
}
