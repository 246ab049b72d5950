#include "render/picture/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "render/liquid/particles.hpp"
#include "render/outputs.hpp"
#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.length = 0.2, .height = 0.1, .depth = 0.05, .spacing = 0.01};

std::map<Rgb, int> colours_of(Quantity quantity, const Frame& frame) {
  Look look;
  look.width = 480;
  look.height = 270;
  look.quantity = quantity;
  look.show_bar = look.show_caption = false;
  const RunInfo run = test::run_info(box);
  const Image image = Painter(run, look).draw(frame, *fixed_range(run, look));
  std::map<Rgb, int> counts;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    ++counts[{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]}];
  return counts;
}

}  // namespace

TEST(Quantity, HasANameATitleAndAValue) {
  Frame frame;
  frame.position.resize(1);
  frame.velocity = {{2, -3, 6}};
  frame.pressure = {-5};
  frame.number_density = {0.5f};
  frame.free_surface = {1};
  frame.kind = {Kind::dummy};
  const std::map<std::string_view, double> values{
      {"pressure", -5}, {"speed", 7}, {"number-density", 0.5}, {"free-surface", 1}, {"kind", 2}};
  for (const QuantityRow& row : ChoiceTable<Quantity>::rows) {
    EXPECT_EQ(&row_of(row.value), &row);
    EXPECT_NE(title_of(row.value), "") << row.name;
    if (values.contains(row.name)) {
      EXPECT_EQ(value_of(row.value, frame, 0), values.at(row.name)) << row.name;
    } else {
      EXPECT_THROW(value_of(row.value, frame, 0), std::runtime_error) << row.name << " isn't in files of before";
      frame.derived.push_back({row.value, {-3}});
      EXPECT_EQ(value_of(row.value, frame, 0), -3) << row.name;
    }
  }
  EXPECT_EQ(title_of(Quantity::speed), "speed [m/s]");
}

TEST(Quantity, ColoursTheFluidByIt) {
  auto frame = *test::lattice(box, 0);
  for (auto& velocity : frame.velocity) velocity = {0.3f, 0, 0.4f};
  const RunInfo run = test::run_info(box);
  const Range range = scene_range(run, Quantity::speed);
  const Rgb expected = ColourMap(ColourMapName::viridis)((0.5 - range.low) / (range.high - range.low));
  EXPECT_GT(colours_of(Quantity::speed, frame)[expected], 1000);
  EXPECT_EQ(colours_of(Quantity::pressure, frame)[expected], 0);
}

TEST(Quantity, ClassesHaveColoursOfTheirOwnAndNoMarks) {
  const auto frame = test::lattice(box, 0);
  auto surface = colours_of(Quantity::free_surface, *frame);
  for (const Class& each : classes_of(Quantity::free_surface)) EXPECT_GT(surface[each.colour], 400) << each.name;
  EXPECT_EQ(surface[Particles::surface_colour], 0);
  EXPECT_GT(surface[Particles::wall_colour], 400);
  auto kinds = colours_of(Quantity::kind, *frame);
  for (const Class& each : classes_of(Quantity::kind)) EXPECT_GT(kinds[each.colour], 400) << each.name;
  EXPECT_EQ(kinds[Particles::wall_colour], 0);
}
