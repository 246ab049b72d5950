#include "render/liquid/surface_sign.hpp"

#include <gtest/gtest.h>

using namespace seiche::render;

TEST(SurfaceSign, IsOneAlone) {
  Look look;
  EXPECT_EQ(surface_sign(look), SurfaceSign::rings);
  look.show_surface_line = true;
  EXPECT_EQ(surface_sign(look), SurfaceSign::line);
  look.show_surface = false;
  EXPECT_EQ(surface_sign(look), SurfaceSign::line) << "asked for by its own name";
  look.show_surface_line = false;
  EXPECT_EQ(surface_sign(look), SurfaceSign::none);
}

TEST(SurfaceSign, IsALineWhereThereAreNoParticles) {
  Look look;
  look.style = Style::smooth;
  EXPECT_EQ(surface_sign(look), SurfaceSign::line);
  look.show_surface = false;
  EXPECT_EQ(surface_sign(look), SurfaceSign::none);
}

TEST(SurfaceSign, IsNotNeededWhereColoursTell) {
  Look look;
  look.quantity = Quantity::free_surface;
  EXPECT_EQ(surface_sign(look), SurfaceSign::none);
}
