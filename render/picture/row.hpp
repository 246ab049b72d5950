#pragma once
#include <algorithm>

#include "render/picture/boxes.hpp"

namespace seiche::render {

/// Two items at the ends of a row, or below each other where the row is too short [pixels].
struct Row {
  double left, right, room, font;
  double gap() const { return left > 0 && right > 0 ? 2 * font : 0; }
  bool stacked() const { return left + gap() + right > room; }
  double height() const {
    if (left <= 0 && right <= 0) return 0;
    return (stacked() && gap() > 0 ? 2.9 : 1.5) * font;
  }
  void place(double x, double top, Box& first, Box& second) const {
    first = {x, top - font, std::min(left, room), font};
    second = {stacked() ? x : x + room - right, stacked() && gap() > 0 ? top - 2.4 * font : top - font, right, font};
  }
};

}  // namespace seiche::render
