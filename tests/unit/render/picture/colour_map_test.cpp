#include "render/picture/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace seiche::render;

namespace {

struct Known {
  const char* map;
  double at;
  Rgb colour;
};

// Of the 256 colours that the maps' authors publish: numbers 0, 64, 128, 200 and 255.
const Known published[] = {
    {"viridis", 0, {68, 1, 84}},
    {"viridis", 64 / 255.0, {59, 82, 139}},
    {"viridis", 128 / 255.0, {33, 145, 140}},
    {"viridis", 200 / 255.0, {112, 207, 87}},
    {"viridis", 1, {253, 231, 37}},
    {"cividis", 0, {0, 34, 78}},
    {"cividis", 64 / 255.0, {67, 78, 108}},
    {"cividis", 128 / 255.0, {125, 124, 120}},
    {"cividis", 200 / 255.0, {196, 180, 104}},
    {"cividis", 1, {254, 232, 56}},
    {"cool-warm", 0, {59, 76, 192}},
    {"cool-warm", 64 / 255.0, {141, 176, 254}},
    {"cool-warm", 128 / 255.0, {221, 220, 220}},
    {"cool-warm", 200 / 255.0, {240, 139, 110}},
    {"cool-warm", 1, {180, 4, 38}},
    {"turbo", 0, {48, 18, 59}},
    {"turbo", 64 / 255.0, {40, 188, 235}},
    {"turbo", 128 / 255.0, {164, 252, 60}},
    {"turbo", 200 / 255.0, {244, 102, 23}},
    {"turbo", 1, {122, 4, 3}},
};

}  // namespace

TEST(ColourMap, MeetsThePublishedColours) {
  for (const Known& known : published) {
    const Rgb colour = ColourMap(known.map)(known.at);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(colour[c], known.colour[c], 2) << known.map << " at " << known.at << ", channel " << c;
  }
}

TEST(ColourMap, GivesTheEndsToWhatIsBeyond) {
  for (const auto& name : colour_map_names()) {
    const ColourMap map(name);
    EXPECT_EQ(map(-3), map(0));
    EXPECT_EQ(map(1.001), map(1));
    EXPECT_EQ(map(std::numeric_limits<double>::quiet_NaN()), map(0));
    EXPECT_EQ(map(std::numeric_limits<double>::infinity()), map(1));
  }
}

TEST(ColourMap, HasNoJumps) {
  for (const auto& name : colour_map_names()) {
    const ColourMap map(name);
    for (int i = 0; i < 1000; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(map(i / 1000.0)[c] - map((i + 1) / 1000.0)[c]), 4) << name << " after " << i;
  }
}

TEST(ColourMap, RefusesUnknownNames) {
  try {
    ColourMap("jet");
    FAIL() << "jet was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("viridis"), std::string::npos) << "the names are told";
  }
}
