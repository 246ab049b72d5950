#include <gtest/gtest.h>

#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/image/baseline.hpp"
#include "tests/image/ssim.hpp"
#include "tests/unit/render/synthetic.hpp"

// Ways to show the liquid that aren't discs alone, against baselines.
using namespace seiche;
using namespace seiche::render;
using test::expect_baseline, test::least_tile, test::sized;

namespace {

const test::Box sloshing{.spacing = 0.01}, fine{.spacing = 0.005};

// At speeds of up to 0.3 m/s.
Image draw(const Look& look, const test::Box& box) {
  auto frame = std::make_shared<Frame>(*test::lattice(box, 0.2, 62));
  for (Float3& velocity : frame->velocity)
    for (float& component : velocity) component *= 2.5f;
  const auto run = test::run_info(box);
  return Painter(run, look).draw(*frame, scene_range(run));
}

Look arrows(int width, int height) {
  Look look = sized(width, height);
  look.show_arrows = true;
  return look;
}

Look smooth(int width, int height) {
  Look look = sized(width, height);
  look.style = Style::smooth;
  return look;
}

}  // namespace

TEST(Looks, ArrowsSmall) { expect_baseline("arrows-small", draw(arrows(640, 360), sloshing)); }

TEST(Looks, ArrowsLarge) { expect_baseline("arrows-large", draw(arrows(1280, 720), fine)); }

TEST(Looks, SurfaceLine) {
  Look look = sized(640, 360);
  look.show_surface_line = true;
  expect_baseline("surface-line", draw(look, sloshing));
}

TEST(Looks, SmoothSmall) { expect_baseline("smooth-small", draw(smooth(640, 360), sloshing)); }

TEST(Looks, SmoothLarge) { expect_baseline("smooth-large", draw(smooth(1280, 720), fine)); }

TEST(Looks, BaselinesSeeThatArrowsOrTheLineAreMissing) {
  const Image plain = draw(sized(640, 360), sloshing);
  EXPECT_LT(test::similarity(draw(arrows(640, 360), sloshing), plain).least, least_tile);
  Look unlined = smooth(640, 360);
  unlined.show_surface = false;
  EXPECT_LT(test::similarity(draw(smooth(640, 360), sloshing), draw(unlined, sloshing)).least, least_tile);
}
