#include "render/panels/comparison.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "render/curves/curve_choice.hpp"
#include "render/liquid/particles.hpp"
#include "render/panels/compared_curves.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/range.hpp"
#include "tests/unit/render/synthetic_comparison.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.spacing = 0.02};

Look small() {
  Look look;
  look.width = 640;
  look.height = 360;
  return look;
}

std::string title(const SensorCurve& curve) { return curve.title; }

// Pixels of a colour, within what smoothing does to it.
long pixels_of(const Image& image, Rgb colour) {
  long found = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    bool same = true;
    for (std::size_t c = 0; c < 3; ++c) same = same && std::abs(image.rgba[i + c] - colour[c]) < 25;
    found += same;
  }
  return found;
}

}  // namespace

TEST(ComparedCurves, AreOnePlotToASensorWithACurveOfEachRun) {
  const auto curves = compared_curves(test::variants(box, 3), Look{});
  ASSERT_EQ(curves.size(), 2u) << "the tank's motion is the same for all";
  EXPECT_EQ(title(curves[0]), "elevation, left [m]");
  EXPECT_EQ(title(curves[1]), "pressure, left bottom [Pa]");
  for (const SensorCurve& curve : curves) {
    ASSERT_EQ(curve.traces.size(), 3u);
    EXPECT_NE(curve.traces[0].colour, curve.traces[1].colour);
    EXPECT_FALSE(curve.traces[0].broken_off);
    EXPECT_TRUE(curve.traces[1].broken_off);
  }
}

TEST(ComparedCurves, FindTheirSensorWhereverItStandsAndAreAsLongAsTheLongestRun) {
  auto variants = test::variants(box, 2);
  variants[1].run.sensors = {variants[0].run.sensors[1]};
  variants[1].run.end = 20;
  const auto curves = compared_curves(variants, Look{});
  EXPECT_EQ(curves[0].traces[0].column, 1u);
  EXPECT_EQ(curves[0].traces[1].column, 0u);
  EXPECT_GE(curves[1].traces[1].column, 1u) << "it has no pressure sensor";
  EXPECT_EQ(curves[0].end, 20);
  Comparison comparison(variants, Look{});
  comparison.record(1, {{0, 1}, {0.1, 0.2}});
}

TEST(ComparedCurves, MotionIsShownWhereItIsAskedFor) {
  Look look;
  look.curves = parse_curves("surge");
  EXPECT_EQ(compared_curves(test::variants(box, 2), look).size(), 1u);
}

TEST(Settle, AxesHoldTheRunsThatDidNotFailAndTheReference) {
  Look look;
  look.curves = parse_curves("eta_left");
  look.references = {test::reference(2)};
  auto curves = compared_curves(test::variants(box, 2), look);
  record(curves[0], test::readings(0, 10), 0);
  record(curves[0], {{0, 1}, {0, 0, 0, 0, 0, 1e6, 0, 0}}, 1);
  settle(curves);
  const Range axis = axis_range(curves[0]);
  EXPECT_GE(axis.high, 2 * 0.115);
  EXPECT_LT(axis.high, 0.5);
  EXPECT_LE(axis.low, -2 * 0.115);
}

TEST(Settle, PressuresAreMeansAndSaySo) {
  Look look;
  look.curves = parse_curves("p_left_bottom, eta_left");
  auto curves = compared_curves(test::variants(box, 1), look);
  const Readings raw = test::readings(0, 10, 1000);
  for (SensorCurve& curve : curves) record(curve, raw);
  settle(curves);
  EXPECT_EQ(title(curves[0]), "pressure, left bottom [Pa], mean of 0.1 s");
  double sum = 0;
  for (long k = 1950; k <= 2050; ++k) sum += raw.values[static_cast<std::size_t>(4 * k)];
  EXPECT_NEAR((*latest(curves[0].traces[0], 2))[1], sum / 101, 1e-9);
  EXPECT_EQ((*latest(curves[1].traces[0], 2))[1], test::reading(2)[1]) << "an elevation stays as it is";
}

TEST(Comparison, RefusesTooManyAndMixedDimensions) {
  EXPECT_THROW(Comparison(test::variants(box, 10), Look{}), std::invalid_argument);
  EXPECT_THROW(Comparison({}, Look{}), std::invalid_argument);
  auto mixed = test::variants(box, 2);
  mixed[1].run.dimension = 3;
  EXPECT_THROW(Comparison(mixed, Look{}), std::invalid_argument);
}

TEST(Comparison, APictureTooSmallIsRefused) {
  Look tiny = small();
  tiny.width = tiny.height = 64;
  EXPECT_THROW(test::draw_comparison(tiny, box, 9, 0), std::invalid_argument);
}

TEST(Comparison, AllPanelsHaveOneRange) {
  // Both runs have the same pressures, so both show the uppermost colour of a range that ends below them, or neither.
  Look look = small();
  look.curves.emplace();
  look.show_bar = false;
  const auto yellow = [&](Range range) {
    Comparison comparison(test::variants(box, 2), look);
    const auto frame = test::lattice(box, 0);
    const Image image = comparison.draw(0, {{frame, false}, {frame, false}}, range);
    std::array<long, 2> found{};
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x);
        found[x < image.width / 2 ? 0 : 1] +=
            image.rgba[at] > 200 && image.rgba[at + 1] > 180 && image.rgba[at + 2] < 80;
      }
    return found;
  };
  const auto low = yellow({0, 500}), high = yellow({0, 20000});
  EXPECT_GT(low[0], 1000);
  EXPECT_NEAR(static_cast<double>(low[0]), static_cast<double>(low[1]), 0.03 * static_cast<double>(low[0]));
  EXPECT_LT(high[0] + high[1], 20);
}

TEST(Comparison, ARunThatFailedIsDimmedFromThenOn) {
  Look look = small();
  look.curves.emplace();
  look.show_bar = false;
  const long before = pixels_of(test::draw_comparison(look, box, 2, test::failure), Particles::wall_colour);
  const long after = pixels_of(test::draw_comparison(look, box, 2, test::failure + 0.02), Particles::wall_colour);
  EXPECT_NEAR(static_cast<double>(after) / static_cast<double>(before), 0.5, 0.1) << "the walls of one panel pale";
}

TEST(Comparison, AnotherTimeIsAnotherPictureOnTheSameAxes) {
  const Image early = test::draw_comparison(small(), box, 3, 2), late = test::draw_comparison(small(), box, 3, 8);
  const Rgb blue = palette(Background::white).runs[0];
  EXPECT_GT(pixels_of(late, blue), pixels_of(early, blue) + 100) << "a longer curve";
}
