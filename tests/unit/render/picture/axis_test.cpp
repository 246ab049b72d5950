#include "render/picture/axis.hpp"

#include <gtest/gtest.h>

#include "render/picture/overlay.hpp"

using namespace seiche::render;

TEST(Axis, HasALabelAtEachRoundNumberWithinTheRange) {
  const Axis axis = axis_of({-130, 370}, 5);
  ASSERT_EQ(axis.ticks.size(), 5u);
  EXPECT_EQ(axis.ticks.front().position, -100);
  EXPECT_EQ(axis.ticks.front().label, "\u2212100");
  EXPECT_EQ(axis.ticks[1].label, "0");
  EXPECT_EQ(axis.ticks.back().label, "300");
}

TEST(Axis, IsCutIntoNoMorePartsThanAskedFor) {
  for (int most = fewest_ticks; most <= most_ticks; ++most)
    EXPECT_LE(axis_of({0, 1}, most).ticks.size(), static_cast<std::size_t>(most) + 1) << most;
  EXPECT_LT(axis_of({0, 1}, fewest_ticks).ticks.size(), axis_of({0, 1}).ticks.size());
}

TEST(Axis, PlacesLieAlongIt) {
  const Axis axis = axis_of({-2, 6});
  EXPECT_EQ(axis.along(-2), 0);
  EXPECT_EQ(axis.along(6), 1);
  EXPECT_EQ(axis.along(0), 0.25);
}

TEST(Axis, IsAsWideAsItsWidestLabel) {
  EXPECT_EQ(label_width(axis_of({0, 3000})), text_width("1000"));
  EXPECT_EQ(label_width(Axis{}), 0);
}
