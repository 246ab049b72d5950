#include "render/picture/curve_layout.hpp"

#include <algorithm>

#include "render/picture/row.hpp"

namespace seiche::render {
namespace {

// In font heights.
constexpr double between = 1.6, tick_row = 1.5, below = 0.9, axis_gap = 0.6, head_gap = 0.35, narrowest = 8;

// What all curves have in common, so that their axes are alike [pixels].
struct Common {
  double slot;         // width of a curve with its labels
  double left, right;  // of it, beside the plot
  double head;         // height above the plot
};

Row head(const CurveNeeds& curve, double slot, double font) {
  return {std::min(curve.title * font, slot), std::min(curve.key * font, slot), slot, curve_font * font};
}

Common common(const std::vector<CurveNeeds>& needs, double width, double font) {
  const auto count = static_cast<double>(needs.size());
  Common all{.slot = (width - (count - 1) * between * font) / count, .left = 0, .right = 0, .head = 0};
  for (const CurveNeeds& curve : needs) {
    all.left = std::max(all.left, (curve.labels + axis_gap) * font);
    all.right = std::max(all.right, curve.last_label / 2 * font);
    all.head = std::max(all.head, head(curve, all.slot, font).height());
  }
  all.head += head_gap * font;  // the topmost value's label reaches above the plot
  return all;
}

}  // namespace

double curve_strip(const Needs& needs, double font) {
  if (needs.curves.empty()) return 0;
  const Common all = common(needs.curves, needs.width - 2 * layout_pad * font, font);
  if (all.slot - all.left - all.right < narrowest * font) return 0;
  const double rows = all.head + (tick_row + below) * font;
  return rows + std::clamp(needs.plot * needs.height, 3.2 * font, 9 * font / needs.font);
}

std::vector<CurveBoxes> lay_out_curves(const std::vector<CurveNeeds>& needs, const Box& strip, double font) {
  std::vector<CurveBoxes> places;
  if (needs.empty()) return places;
  const Common all = common(needs, strip.width, font);
  const double bottom = strip.y + (below + tick_row) * font, top = strip.top() - all.head;
  double x = strip.x;
  for (const CurveNeeds& curve : needs) {
    CurveBoxes place;
    const Row row = head(curve, all.slot, font);
    row.place(x, top + head_gap * font + row.height(), place.title, place.key);
    place.plot = {x + all.left, bottom, all.slot - all.left - all.right, top - bottom};
    place.values = {x, bottom, all.left - axis_gap * font, place.plot.height};
    place.times = {x, bottom - tick_row * font, all.slot, (tick_row - 0.4) * font};
    places.push_back(place);
    x += all.slot + between * font;
  }
  return places;
}

}  // namespace seiche::render
