#pragma once
#include "render/overlay.hpp"
#include "render/palette.hpp"
#include "render/sensor_curve.hpp"

namespace seiche::render {

/// How a reference is dashed: lengths of a dash and of a gap, in font heights. Each of a curve's references has its own.
struct Dashes {
  double dash, gap;
};
Dashes dashes_of(std::size_t reference);

/// Widths of lines, in font heights.
constexpr double curve_width = 0.13, reference_width = 0.085;

/// Width of the key to a curve's lines, in font heights; 0 when it has no references and so needs none.
double key_width(const SensorCurve& curve);

/// Draws the key from the left of `place` on, cut where it is too long.
void place_key(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours);

}  // namespace seiche::render
