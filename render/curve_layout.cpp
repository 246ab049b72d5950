#include "render/curve_layout.hpp"

#include <algorithm>

#include "render/row.hpp"

namespace seiche::render {
namespace {

// In font heights.
constexpr double between = 1.6, tick_row = 1.5, below = 0.9, axis_gap = 0.6, head_gap = 0.35;

double slot_width(const std::vector<CurveNeeds>& needs, double width, double font) {
  const auto gaps = static_cast<double>(needs.size() - 1) * between * font;
  return (width - gaps) / static_cast<double>(needs.size());
}

Row head(const CurveNeeds& curve, double slot, double font) {
  const double small = curve_font * font;
  return {std::min(curve.title * font, slot), std::min(curve.key * font, slot), slot, small};
}

double head_height(const std::vector<CurveNeeds>& needs, double slot, double font) {
  double height = 0;
  for (const CurveNeeds& curve : needs) height = std::max(height, head(curve, slot, font).height());
  return height + head_gap * font;  // the topmost value's label reaches above the plot
}

}  // namespace

double curve_strip(const Needs& needs, double font) {
  if (needs.curves.empty()) return 0;
  const double slot = slot_width(needs.curves, needs.width - 2 * layout_pad * font, font);
  for (const CurveNeeds& curve : needs.curves)
    if (slot < (curve.labels + curve.last_label + 8) * font) return 0;
  const double rows = head_height(needs.curves, slot, font) + (tick_row + below) * font;
  return rows + std::clamp(0.16 * needs.height, 3.2 * font, 9 * font);
}

std::vector<CurvePlace> lay_out_curves(const std::vector<CurveNeeds>& needs, const Box& strip, double font) {
  std::vector<CurvePlace> places;
  if (needs.empty()) return places;
  const double slot = slot_width(needs, strip.width, font), rows = head_height(needs, slot, font);
  double x = strip.x;
  for (const CurveNeeds& curve : needs) {
    const double left = (curve.labels + axis_gap) * font, right = curve.last_label / 2 * font;
    const double bottom = strip.y + (below + tick_row) * font;
    CurvePlace place;
    head(curve, slot, font).place(x, strip.top(), place.title, place.key);
    place.plot = {x + left, bottom, slot - left - right, strip.top() - rows - bottom};
    place.values = {x, place.plot.y, curve.labels * font, place.plot.height};
    place.times = {x, bottom - tick_row * font, slot, (tick_row - 0.4) * font};
    places.push_back(place);
    x += slot + between * font;
  }
  return places;
}

}  // namespace seiche::render
