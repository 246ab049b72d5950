#include "render/liquid/surface_mark.hpp"

#include <gtest/gtest.h>

using namespace seiche;
using namespace seiche::render;

TEST(SurfaceMark, IsOneAlone) {
  Look look;
  EXPECT_EQ(surface_mark(look), SurfaceMark::rings);
  look.show_surface_line = true;
  EXPECT_EQ(surface_mark(look), SurfaceMark::line);
  look.show_surface = false;
  EXPECT_EQ(surface_mark(look), SurfaceMark::line) << "asked for by its own name";
  look.show_surface_line = false;
  EXPECT_EQ(surface_mark(look), SurfaceMark::none);
}

TEST(SurfaceMark, IsALineWhereThereAreNoParticles) {
  Look look;
  look.style = Style::smooth;
  EXPECT_EQ(surface_mark(look), SurfaceMark::line);
  look.show_surface = false;
  EXPECT_EQ(surface_mark(look), SurfaceMark::none);
}

TEST(SurfaceMark, IsNotNeededWhereColoursTell) {
  Look look;
  look.quantity = Quantity::free_surface;
  EXPECT_EQ(surface_mark(look), SurfaceMark::none);
}
