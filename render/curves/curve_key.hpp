#pragma once
#include "render/curves/sensor_curve.hpp"
#include "render/picture/overlay.hpp"
#include "render/picture/palette.hpp"

namespace seiche::render {

/// How a reference is dashed: lengths of a dash and of a gap, in font heights. Each of a curve's references has its
/// own.
struct Dashes {
  double dash, gap;
};
Dashes dashes_of(std::size_t reference);

/// Widths of lines, in font heights.
constexpr double curve_width = 0.13, reference_width = 0.085;

/// Widths of the curve's title and of the key to its references, in font heights; 0 where it has none. Beside
/// references the title of a single run's curve stands behind a piece of it, as in a key.
double title_width(const SensorCurve& curve);
double key_width(const SensorCurve& curve);

/// Draws them from the left of `place` on, cut where they are too long.
void place_title(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours);
void place_key(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours);

}  // namespace seiche::render
