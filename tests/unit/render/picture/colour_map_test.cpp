#include "render/picture/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace seiche::render;

namespace {

struct Known {
  ColourMapName map;
  double at;
  Rgb colour;
};

// Of the 256 colours that the maps' authors publish: numbers 0, 64, 128, 200 and 255.
const Known published[] = {
    {ColourMapName::viridis, 0, {68, 1, 84}},
    {ColourMapName::viridis, 64 / 255.0, {59, 82, 139}},
    {ColourMapName::viridis, 128 / 255.0, {33, 145, 140}},
    {ColourMapName::viridis, 200 / 255.0, {112, 207, 87}},
    {ColourMapName::viridis, 1, {253, 231, 37}},
    {ColourMapName::cividis, 0, {0, 34, 78}},
    {ColourMapName::cividis, 64 / 255.0, {67, 78, 108}},
    {ColourMapName::cividis, 128 / 255.0, {125, 124, 120}},
    {ColourMapName::cividis, 200 / 255.0, {196, 180, 104}},
    {ColourMapName::cividis, 1, {254, 232, 56}},
    {ColourMapName::cool_warm, 0, {59, 76, 192}},
    {ColourMapName::cool_warm, 64 / 255.0, {141, 176, 254}},
    {ColourMapName::cool_warm, 128 / 255.0, {221, 220, 220}},
    {ColourMapName::cool_warm, 200 / 255.0, {240, 139, 110}},
    {ColourMapName::cool_warm, 1, {180, 4, 38}},
    {ColourMapName::turbo, 0, {48, 18, 59}},
    {ColourMapName::turbo, 64 / 255.0, {40, 188, 235}},
    {ColourMapName::turbo, 128 / 255.0, {164, 252, 60}},
    {ColourMapName::turbo, 200 / 255.0, {244, 102, 23}},
    {ColourMapName::turbo, 1, {122, 4, 3}},
};

}  // namespace

TEST(ColourMap, MeetsThePublishedColours) {
  for (const Known& known : published) {
    const Rgb colour = ColourMap(known.map)(known.at);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(colour[c], known.colour[c], 2) << seiche::name(known.map) << " at " << known.at << ", channel " << c;
  }
}

TEST(ColourMap, GivesTheEndsToWhatIsBeyond) {
  for (const auto& row : seiche::ChoiceTable<ColourMapName>::rows) {
    const ColourMap map(row.value);
    EXPECT_EQ(map(-3), map(0));
    EXPECT_EQ(map(1.001), map(1));
    EXPECT_EQ(map(std::numeric_limits<double>::quiet_NaN()), map(0));
    EXPECT_EQ(map(std::numeric_limits<double>::infinity()), map(1));
  }
}

TEST(ColourMap, HasNoJumps) {
  for (const auto& row : seiche::ChoiceTable<ColourMapName>::rows) {
    const ColourMap map(row.value);
    for (int i = 0; i < 1000; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(map(i / 1000.0)[c] - map((i + 1) / 1000.0)[c]), 4) << row.name << " after " << i;
  }
}
