#include "render/check_look.hpp"

#include <gtest/gtest.h>

using namespace seiche;
using namespace seiche::render;

TEST(Look, DefaultsCanBeDrawn) { EXPECT_NO_THROW(check_look(Look{})); }

TEST(Look, SizesHaveBounds) {
  for (const auto& [width, height] : {std::pair{63, 720}, {1280, 0}, {-1, 720}, {1280, 8193}}) {
    Look look;
    look.width = width;
    look.height = height;
    EXPECT_THROW(check_look(look), std::invalid_argument) << width << " x " << height;
  }
}

TEST(Look, SmoothNeedsANumber) {
  Look look;
  look.style = Style::smooth;
  EXPECT_NO_THROW(check_look(look));
  look.quantity = Quantity::kind;
  EXPECT_THROW(check_look(look), std::invalid_argument);
}

TEST(Look, WhatNeedsAPlaneIsRefusedIn3d) {
  EXPECT_NO_THROW(check_dimension(Look{}, 3));
  const auto refused = [](auto change) {
    Look look;
    change(look);
    EXPECT_NO_THROW(check_dimension(look, 2));
    EXPECT_THROW(check_dimension(look, 3), std::invalid_argument);
  };
  refused([](Look& look) { look.show_arrows = true; });
  refused([](Look& look) { look.show_surface_line = true; });
  refused([](Look& look) { look.style = Style::smooth; });
}
