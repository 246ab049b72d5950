#include "render/liquid/arrow.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

Line bar(double from, double to, double half) { return {{from, -half}, {to, -half}, {to, half}, {from, half}}; }

Line turned(Line line, const Point& middle, const Point& direction) {
  for (auto& [x, y] : line) {
    const double along = x;
    x = middle[0] + along * direction[0] - y * direction[1];
    y = middle[1] + along * direction[1] + y * direction[0];
  }
  return line;
}

}  // namespace

ArrowShape arrow_shape(double length, double font) {
  const double head = std::min(0.5 * font, 0.6 * length), size = head / (0.5 * font);
  const double wide = 0.4 * head, half = 0.06 * font * size, halo = 0.06 * font * std::sqrt(size);
  const double tail = -length / 2, tip = length / 2, neck = tip - head;
  // The halo's slanting edges are as far from the head's as its other edges are.
  const double slope = wide / head, ahead = halo * std::sqrt(1 + 1 / (slope * slope));
  const double back = neck - halo, broad = (tip + ahead - back) * slope;
  return {.shaft = bar(tail, neck + 0.1 * head, half),
          .head = {{neck, -wide}, {tip, 0}, {neck, wide}},
          .shaft_halo = bar(tail - halo, neck, half + halo),
          .head_halo = {{back, -broad}, {tip + ahead, 0}, {back, broad}}};
}

ArrowShape placed(const ArrowShape& arrow, const Point& middle, const Point& direction) {
  return {.shaft = turned(arrow.shaft, middle, direction),
          .head = turned(arrow.head, middle, direction),
          .shaft_halo = turned(arrow.shaft_halo, middle, direction),
          .head_halo = turned(arrow.head_halo, middle, direction)};
}

}  // namespace seiche::render
