#include <gtest/gtest.h>

#include "render/curves/curve_choice.hpp"
#include "render/picture/range.hpp"
#include "tests/image/baseline.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

// Pictures with curves under them.
using namespace seiche;
using namespace seiche::render;
using test::sized;

namespace {

Image draw(const Look& look, double end = 10) {
  const test::Box tank{.spacing = 0.01};
  RunInfo run = test::run_with_sensors(tank);
  run.end = end;
  Painter painter(run, look);
  const auto frame = test::lattice(tank, 0.2, 186);
  painter.record(test::readings(0, frame->time, 1000));
  return painter.draw(*frame, scene_range(run));
}

}  // namespace

TEST(CurvesBaseline, ThreeByThemselves) { test::expect_baseline("curves-large", draw(sized(1280, 720))); }

TEST(CurvesBaseline, TwoWithAReference) {
  Look look = sized(640, 480);
  look.curves = parse_curves("eta_left, p_left_bottom");
  look.references = {test::reference()};
  test::expect_baseline("curves-small", draw(look));
}

TEST(CurvesBaseline, OneWithTwoReferencesOnBlack) {
  Look look = sized(640, 360);
  look.background = Background::black;
  look.curves = parse_curves("eta_left");
  look.references = {test::reference(), test::reference(0.7)};
  look.references.back().label = "linear theory";
  test::expect_baseline("curves-black", draw(look, 8.5));
}

TEST(CurvesBaseline, Transparent) {
  Look look = sized(1280, 720);
  look.background = Background::transparent;
  look.curves = parse_curves("eta_right, surge");
  test::expect_baseline("curves-transparent", draw(look, 3.8));
}
