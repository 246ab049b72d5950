#include "render/picture/layout.hpp"

#include <gtest/gtest.h>

#include "tests/unit/render/layout_boxes.hpp"

using namespace seiche::render;
using seiche::test::expect_inside_and_apart;
using seiche::test::needs;

namespace {

std::vector<CurveNeeds> curves(std::size_t count) {
  std::vector<CurveNeeds> all(count, {.title = 8, .key = 0, .labels = 4, .last_label = 1});
  if (count > 0) all[0].key = 18;
  return all;
}

}  // namespace

TEST(Layout, NothingIsClippedAndNothingOverlaps) {
  const int sizes[][2] = {{640, 360}, {1280, 720}, {3840, 2160}, {720, 1280}, {1000, 1000}, {1920, 400}, {480, 360}};
  const double views[][2] = {{0.6, 0.4}, {3, 0.3}, {0.3, 1.2}, {1, 1}};
  for (const auto& [width, height] : sizes)
    for (const auto& [across, up] : views) {
      for (std::size_t count = 0; count <= 3; ++count) {
        SCOPED_TRACE(testing::Message() << width << " x " << height << " pixels for " << across << " x " << up << " m, "
                                        << count << " curves");
        Needs all = needs(width, height, across, up);
        all.curves = curves(count);
        const Layout layout = lay_out(all);
        ASSERT_GT(layout.scale, 0);
        std::vector<Box> boxes{layout.view, layout.caption, layout.clock, layout.ruler, layout.key, layout.bar};
        for (const CurveBoxes& place : layout.curves) {
          EXPECT_GE(place.plot.height, 3 * layout.font);
          EXPECT_GE(place.plot.width, 8 * layout.font);
          boxes.insert(boxes.end(), {place.plot, place.title, place.values, place.times});
          if (place.key.width > 0) boxes.push_back(place.key);
        }
        expect_inside_and_apart(boxes, width, height);
        EXPECT_GE(layout.caption.width, all.caption * layout.font * 0.999) << "the caption is cut";
      }
    }
}

TEST(Layout, ViewKeepsItsShape) {
  const Layout layout = lay_out(needs(1280, 720, 0.6, 0.4));
  EXPECT_NEAR(layout.view.width / layout.view.height, 1.5, 1e-9);
  EXPECT_NEAR(layout.view.width, 0.6 * layout.scale, 1e-9);
}

TEST(Layout, BarStandsBesideATallTankAndLiesBelowAFlatOne) {
  EXPECT_TRUE(lay_out(needs(1280, 720, 0.3, 1.2)).bar_upright);
  EXPECT_FALSE(lay_out(needs(1280, 720, 3, 0.3)).bar_upright);
}

TEST(Layout, GrowsWithThePicture) {
  const Layout small = lay_out(needs(1280, 720, 0.6, 0.4)), large = lay_out(needs(3840, 2160, 0.6, 0.4));
  EXPECT_NEAR(large.font, 3 * small.font, 1e-9);
  EXPECT_NEAR(large.scale, 3 * small.scale, 1e-6);
}

TEST(Layout, HiddenPartsLeaveTheirRoomToTheTank) {
  Needs all = needs(1280, 720, 0.6, 0.4);
  const double with_bar = lay_out(all).scale;
  all.caption = all.clock = all.key = all.ruler = all.bar_labels = 0;
  EXPECT_GT(lay_out(all).scale, 1.1 * with_bar);
}

TEST(Layout, CurvesTakeAFifthToTwoFifthsOfTheHeight) {
  const int sizes[][2] = {{640, 480}, {1280, 720}, {1920, 1080}, {640, 360}};
  for (const auto& [width, height] : sizes) {
    Needs all = needs(width, height, 0.6, 0.4);
    all.curves = curves(2);
    const Layout layout = lay_out(all);
    ASSERT_EQ(layout.curves.size(), 2u);
    EXPECT_LT(layout.curves[0].title.top(), 0.4 * height);
    EXPECT_GT(layout.curves[0].title.top(), 0.2 * height);
    EXPECT_EQ(layout.curves[0].plot.y, layout.curves[1].plot.y);
    EXPECT_EQ(layout.curves[0].plot.height, layout.curves[1].plot.height);
  }
}

TEST(Layout, APictureTooSmallForCurvesIsAsWithoutThem) {
  const int sizes[][2] = {{200, 150}, {1920, 200}, {300, 600}};
  for (const auto& [width, height] : sizes) {
    Needs all = needs(width, height, 0.6, 0.4);
    const double scale = lay_out(all).scale;
    all.curves = curves(3);
    EXPECT_TRUE(lay_out(all).curves.empty()) << width;
    EXPECT_EQ(lay_out(all).scale, scale);
  }
}
