#include <gtest/gtest.h>

#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/image/baseline.hpp"
#include "tests/image/ssim.hpp"
#include "tests/unit/render/synthetic.hpp"

// Pictures against baselines.
using namespace seiche;
using namespace seiche::render;
using test::expect_baseline, test::least_mean, test::least_tile, test::sized;

namespace {

const test::Box sloshing{.spacing = 0.01};

Image draw(const Look& look, const test::Box& box, double slope) {
  const auto run = test::run_info(box);
  return Painter(run, look).draw(*test::lattice(box, slope, 62), scene_range(run));
}

}  // namespace

TEST(Baseline, Small) { expect_baseline("small", draw(sized(640, 360), sloshing, 0.2)); }

TEST(Baseline, Large) { expect_baseline("large", draw(sized(1280, 720), sloshing, 0.2)); }

TEST(Baseline, BlackBackground) {
  Look look = sized(640, 360);
  look.background = Background::black;
  look.colour_map = ColourMapName::turbo;
  expect_baseline("black", draw(look, {.length = 1.2, .height = 0.3, .depth = 0.15, .closed = false}, 0.05));
}

TEST(Baseline, Transparent) {
  Look look = sized(640, 360);
  look.background = Background::transparent;
  look.style = Style::dot;
  expect_baseline("transparent", draw(look, sloshing, 0.2));
}

TEST(Baseline, ClassesHaveAKeyInsteadOfARange) {
  Look look = sized(640, 360);
  look.quantity = Quantity::kind;
  expect_baseline("classes", draw(look, sloshing, 0.2));
}

TEST(Baseline, StillTank3d) {
  expect_baseline(
      "still-tank-3d",
      draw(sized(640, 360), {.length = 0.2, .height = 0.2, .width = 0.1, .depth = 0.1, .spacing = 0.01}, 0));
}

TEST(Similarity, OfAPictureWithItselfIsOne) {
  const Image image = draw(sized(640, 360), sloshing, 0.2);
  EXPECT_DOUBLE_EQ(test::similarity(image, image).mean, 1);
  EXPECT_DOUBLE_EQ(test::similarity(image, image).least, 1);
}

TEST(Similarity, OverlooksOneStepOfColour) {
  const Image image = draw(sized(640, 360), sloshing, 0.2);
  Image other = image;
  for (std::size_t i = 0; i < other.rgba.size(); i += 3) other.rgba[i] ^= 1;
  const auto found = test::similarity(image, other);
  EXPECT_GE(found.mean, least_mean);
  EXPECT_GE(found.least, least_tile);
}

TEST(Similarity, SeesAnotherSurface) {
  EXPECT_LT(test::similarity(draw(sized(640, 360), sloshing, 0.2), draw(sized(640, 360), sloshing, 0.15)).mean,
            least_mean);
}

TEST(Similarity, SeesAnotherColourMap) {
  Look other = sized(640, 360);
  other.colour_map = ColourMapName::cividis;
  EXPECT_LT(test::similarity(draw(sized(640, 360), sloshing, 0.2), draw(other, sloshing, 0.2)).mean, least_mean);
}

TEST(Similarity, SeesThatAPartIsMissing) {
  const Image whole = draw(sized(640, 360), sloshing, 0.2);
  for (bool Look::*part : {&Look::show_surface, &Look::show_tank, &Look::show_clock, &Look::show_caption}) {
    Look look = sized(640, 360);
    look.*part = false;
    EXPECT_LT(test::similarity(whole, draw(look, sloshing, 0.2)).least, least_tile);
  }
}
