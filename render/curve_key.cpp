#include "render/curve_key.hpp"

#include "render/polyline.hpp"

namespace seiche::render {
namespace {

constexpr const char* own_label = "this run";
constexpr double mark = 2.2, after_mark = 0.4, between = 1.2;  // in font heights

double entry_width(const std::string& label) { return mark + after_mark + text_width(label); }

}  // namespace

Dashes dashes_of(std::size_t reference) {
  constexpr Dashes all[] = {{0.42, 0.26}, {0.16, 0.2}, {0.8, 0.26}};
  return all[reference % std::size(all)];
}

double key_width(const SensorCurve& curve) {
  if (curve.references.empty()) return 0;
  double width = entry_width(own_label);
  for (const Reference& reference : curve.references) width += between + entry_width(reference.label);
  return width;
}

void place_key(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours) {
  if (curve.references.empty()) return;
  double x = place.x;
  const double y = place.y + place.height / 2;
  const auto entry = [&](const std::string& label, const std::vector<Line>& lines, double width, Rgb colour) {
    const double room = (place.right() - x) / font - mark - after_mark;
    if (room < 2) return;
    for (const Line& line : lines) overlay.line(line, width * font, colour);
    overlay.text(shortened(label, room + 0.01), x + (mark + after_mark) * font, y, font, Align::left, colours.ink);
    x += (between + entry_width(label)) * font;
  };
  const auto sample = [&] { return Line{{x, y}, {x + mark * font, y}}; };
  entry(own_label, {sample()}, curve_width, colours.curve);
  for (std::size_t i = 0; i < curve.references.size(); ++i) {
    const auto [dash, gap] = dashes_of(i);
    entry(curve.references[i].label, dashed(sample(), dash * font, gap * font), reference_width,
          colours.references[i % colours.references.size()]);
  }
}

}  // namespace seiche::render
