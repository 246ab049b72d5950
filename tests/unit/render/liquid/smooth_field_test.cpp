#include "render/liquid/smooth_field.hpp"

#include <gtest/gtest.h>

#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.length = 0.4, .height = 0.3, .depth = 0.15, .spacing = 0.01};

SmoothField still() {
  SmoothField field(test::run_info(box), 0.25 * box.spacing);
  field.take(*test::lattice(box, 0), Quantity::pressure);
  return field;
}

}  // namespace

TEST(SmoothField, FractionIsOneInTheLiquidAlsoAtWallsAndInCorners) {
  const SmoothField field = still();
  for (const double x : {0.0, 0.003, 0.2, 0.396, 0.4})
    for (const double y : {0.0, 0.004, 0.05, 0.11}) EXPECT_NEAR(field.fraction_at(x, y), 1, 0.025) << x << ", " << y;
}

TEST(SmoothField, FractionIsAHalfAtTheSurfaceAndNothingAbove) {
  const SmoothField field = still();
  for (const double x : {0.0, 0.1234, 0.4}) {
    EXPECT_NEAR(field.fraction_at(x, 0.15), SmoothField::surface, 0.03) << x;
    EXPECT_EQ(field.fraction_at(x, 0.175), 0) << x;
  }
  EXPECT_EQ(field.fraction_at(-0.01, 0.05), 0);
}

TEST(SmoothField, MeanOfALinearQuantityIsItsValueInside) {
  const SmoothField field = still();
  const auto row = static_cast<std::size_t>(std::lround(0.07 / field.dy()));
  const double y = static_cast<double>(row) * field.dy();
  for (std::size_t i = 0; i < field.columns(); i += 10)
    EXPECT_NEAR(field.mean()[row * field.columns() + i], 9810 * (0.15 - y), 0.01 * 9810 * 0.15);
}

TEST(SmoothField, OneParticleIsTooLittleForASurface) {
  Frame frame = *test::lattice(box, 0);
  frame.position = {{0.2f, 0.2f, 0}};
  frame.kind = {Kind::fluid};
  SmoothField field(test::run_info(box), 0.25 * box.spacing);
  field.take(frame, Quantity::pressure);
  EXPECT_GT(field.fraction_at(0.2, 0.2), 0.1);
  EXPECT_LT(field.fraction_at(0.2, 0.2), SmoothField::surface);
}

TEST(SmoothField, ParticlesOutsideOrWithoutAPlaceAreLeftOut) {
  Frame frame = *test::lattice(box, 0);
  frame.position = {{-1, 0.1f, 0}, {0.2f, 1e9f, 0}, {std::nanf(""), 0.1f, 0}};
  frame.kind.assign(3, Kind::fluid);
  SmoothField field(test::run_info(box), 0.25 * box.spacing);
  field.take(frame, Quantity::pressure);
  for (const float fraction : field.fraction()) ASSERT_EQ(fraction, 0);
}
