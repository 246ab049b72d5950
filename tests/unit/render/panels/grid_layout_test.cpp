#include "render/panels/grid_layout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render/panels/variant.hpp"
#include "tests/unit/render/layout_boxes.hpp"

using namespace seiche::render;

namespace {

// Of one panel.
Needs needs(int width, int height, double view_width, double view_height) {
  Needs all = seiche::test::needs(width, height, view_width, view_height);
  all.caption = 12;
  all.key = 9;
  all.bar_labels = 5;
  all.curves = {{.title = 11, .key = 5, .labels = 4, .last_label = 1},
                {.title = 16, .key = 5, .labels = 4, .last_label = 1}};
  return all;
}

std::vector<PanelNeeds> panels(std::size_t count) { return std::vector<PanelNeeds>(count, {.label = 4, .note = 11}); }

void expect_good(const GridLayout& grid, int width, int height) {
  const Layout& around = grid.around;
  std::vector<Box> boxes{around.caption, around.clock, around.ruler, around.key, around.bar};
  for (const PanelBoxes& panel : grid.panels) {
    boxes.insert(boxes.end(), {panel.view, panel.label});
    if (panel.note.width > 0) boxes.push_back(panel.note);
  }
  for (const CurveBoxes& place : around.curves)
    boxes.insert(boxes.end(), {place.plot, place.title, place.key, place.values, place.times});
  seiche::test::expect_inside_and_apart(boxes, width, height, 1e-9);
}

}  // namespace

TEST(GridLayout, NothingIsClippedAndNothingOverlaps) {
  const int sizes[][2] = {{1920, 1080}, {1280, 720}, {640, 360}, {3840, 2160}, {1080, 1920}, {1000, 1000}};
  const double views[][2] = {{0.66, 0.46}, {2, 0.5}, {0.4, 0.8}};
  for (const auto& [width, height] : sizes)
    for (const auto& [across, up] : views)
      for (std::size_t count = 1; count <= most_panels; ++count) {
        SCOPED_TRACE(testing::Message() << width << " x " << height << ", " << count << " panels of " << across << " x "
                                        << up << " m");
        const GridLayout grid = lay_out_grid(needs(width, height, across, up), panels(count));
        ASSERT_GT(grid.around.scale, 0);
        ASSERT_EQ(grid.panels.size(), count);
        expect_good(grid, width, height);
      }
}

TEST(GridLayout, PanelsAreOfOneSizeAndWholePixels) {
  const GridLayout grid = lay_out_grid(needs(1920, 1080, 0.66, 0.46), panels(7));
  for (const PanelBoxes& panel : grid.panels) {
    EXPECT_EQ(panel.view.width, grid.panels[0].view.width);
    EXPECT_EQ(panel.view.height, grid.panels[0].view.height);
    for (const double edge : {panel.view.x, panel.view.y, panel.view.right(), panel.view.top()})
      EXPECT_EQ(edge, std::round(edge));
  }
  EXPECT_NEAR(grid.panels[0].view.width, 0.66 * grid.around.scale, 1);
  EXPECT_NEAR(grid.panels[0].view.height, 0.46 * grid.around.scale, 1);
}

TEST(GridLayout, PanelsRunRowByRowFromTheTopLeft) {
  const GridLayout grid = lay_out_grid(needs(1920, 1080, 0.66, 0.46), panels(5));
  const auto& p = grid.panels;
  EXPECT_EQ(p[0].view.y, p[2].view.y);
  EXPECT_LT(p[0].view.right(), p[1].view.x);
  EXPECT_LT(p[3].label.top(), p[0].view.y);
  EXPECT_EQ(p[3].view.x, p[0].view.x);
}

TEST(GridLayout, ColumnsSuitThePictureAndTheTank) {
  const auto columns = [](const GridLayout& grid) {
    std::size_t count = 0;
    while (count < grid.panels.size() && grid.panels[count].view.y == grid.panels[0].view.y) ++count;
    return count;
  };
  EXPECT_EQ(columns(lay_out_grid(needs(1920, 1080, 0.66, 0.46), panels(5))), 3u);
  EXPECT_EQ(columns(lay_out_grid(needs(1920, 1080, 9, 0.3), panels(5))), 1u);
  EXPECT_EQ(columns(lay_out_grid(needs(1920, 1080, 0.3, 1), panels(5))), 5u);
}

TEST(GridLayout, ANoteThatALongLabelLeavesNoRoomForIsLeftOut) {
  auto all = panels(5);
  all[2].label = 200;
  const GridLayout grid = lay_out_grid(needs(1920, 1080, 0.66, 0.46), all);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(grid.panels[i].note.width > 0, i != 2) << i;
  EXPECT_EQ(grid.panels[2].label.width, grid.panels[2].view.width);
}

TEST(GridLayout, ACommonPictureOfFiveIsLegible) {
  const GridLayout grid = lay_out_grid(needs(1920, 1080, 0.66, 0.46), panels(5));
  EXPECT_GE(grid.around.font, 20);
  EXPECT_GE(grid.panels[0].view.width, 400);
  ASSERT_EQ(grid.around.curves.size(), 2u);
  EXPECT_GE(grid.around.curves[0].plot.height, 180);
}
