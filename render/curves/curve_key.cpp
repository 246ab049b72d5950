#include "render/curves/curve_key.hpp"

#include "render/picture/polyline.hpp"

namespace seiche::render {
namespace {

constexpr double mark = 2.2, after_mark = 0.4, between = 1.2;  // in font heights

bool has_sample(const SensorCurve& curve) { return !curve.references.empty() && curve.traces.size() == 1; }

double entry_width(const std::string& label) { return mark + after_mark + text_width(label); }

double middle(const Box& box) { return box.y + box.height / 2; }

Line sample(double x, double y, double font) { return {{x, y}, {x + mark * font, y}}; }

}  // namespace

Dashes dashes_of(std::size_t reference) {
  constexpr Dashes all[] = {{0.42, 0.26}, {0.25, 0.25}, {0.8, 0.26}};
  return all[reference % std::size(all)];
}

double title_width(const SensorCurve& curve) {
  return has_sample(curve) ? entry_width(curve.title) : text_width(curve.title);
}

double key_width(const SensorCurve& curve) {
  double width = 0;
  for (const Reference& reference : curve.references) width += (width > 0 ? between : 0) + entry_width(reference.label);
  return width;
}

void place_title(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours) {
  const double y = middle(place), indent = has_sample(curve) ? mark + after_mark : 0;
  if (indent > 0) overlay.line(sample(place.x, y, font), curve_width * font, curve.traces[0].colour);
  const std::string title = shortened(curve.title, place.width / font - indent + 0.01);
  overlay.text(title, place.x + indent * font, y, font, Align::left, colours.foreground);
}

void place_key(Overlay& overlay, const SensorCurve& curve, const Box& place, double font, const Palette& colours) {
  double x = place.x;
  const double y = middle(place);
  for (std::size_t i = 0; i < curve.references.size(); ++i) {
    const double room = (place.right() - x) / font - mark - after_mark;
    if (room < 2) return;
    const auto [dash, gap] = dashes_of(i);
    const Rgb colour = colours.references[i % colours.references.size()];
    for (const Line& line : dashed(sample(x, y, font), dash * font, gap * font))
      overlay.line(line, reference_width * font, colour);
    const std::string& label = curve.references[i].label;
    overlay.text(shortened(label, room + 0.01), x + (mark + after_mark) * font, y, font, Align::left,
                 colours.foreground);
    x += (between + entry_width(label)) * font;
  }
}

}  // namespace seiche::render
