#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "render/picture/layout.hpp"

namespace seiche::test {

/// A picture with everything around the tank, without curves.
inline render::Needs needs(int width, int height, double view_width, double view_height) {
  render::Needs all;
  all.width = width;
  all.height = height;
  all.view_width = view_width;
  all.view_height = view_height;
  all.caption = 14;
  all.clock = 6;
  all.key = 12;
  all.ruler = 0.2 * view_width;
  all.ruler_label = 3;
  all.bar_labels = 6;
  all.bar_title = 6.5;
  return all;
}

/// Boxes inside the picture that don't overlap by more than `slack` [pixels].
inline void expect_inside_and_apart(const std::vector<render::Box>& boxes, int width, int height, double slack = 0) {
  const auto apart = [&](const render::Box& a, const render::Box& b) {
    return a.right() <= b.x + slack || b.right() <= a.x + slack || a.top() <= b.y + slack || b.top() <= a.y + slack;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].x, 0) << i;
    EXPECT_GE(boxes[i].y, 0) << i;
    EXPECT_LE(boxes[i].right(), width) << i;
    EXPECT_LE(boxes[i].top(), height) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(apart(boxes[i], boxes[j])) << i << " and " << j;
  }
}

}  // namespace seiche::test
