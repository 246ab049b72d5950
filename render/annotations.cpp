#include "render/annotations.hpp"

#include <fmt/format.h>
#include <vtkTextActor.h>

#include <algorithm>

#include "render/particles.hpp"
#include "render/quantity.hpp"

namespace seiche::render {
namespace {

constexpr const char *surface_words = "free surface", *wall_words = "wall";
constexpr double mark = 1, between = 1.2;  // widths in the key, in font heights

std::string metres(double length) { return fmt::format("{:.3g} m", length); }
std::string clock_text(double seconds) { return fmt::format("t = {:.3f} s", seconds); }

double middle(const Box& box) { return box.y + box.height / 2; }

}  // namespace

std::string caption_of(const RunInfo& run) {
  return fmt::format("{} \u00b7 {} \u00b7 l\u2080 = {:.3g} mm", run.name, run.kernel, 1e3 * run.spacing);
}

// What the colours tell needs no second word.
bool Annotations::keyed_wall() const {
  return look_.show_walls && run_.dimension == 2 && quantity_of(look_.quantity) != Quantity::kind;
}
bool Annotations::keyed_surface() const {
  return look_.show_surface && quantity_of(look_.quantity) != Quantity::free_surface;
}

void Annotations::claim(Needs& needs, double foreshortened) const {
  if (look_.show_caption) needs.caption = text_width(caption_);
  if (look_.show_clock) needs.clock = text_width(clock_text(std::max(run_.end, 1.0)));
  if (keyed_surface()) needs.key += mark + text_width(surface_words);
  if (keyed_wall()) needs.key += (needs.key > 0 ? between : 0) + mark + text_width(wall_words);
  if (look_.show_ruler) {
    needs.ruler = ruler_ * foreshortened;
    needs.ruler_label = text_width(metres(ruler_));
  }
}

void Annotations::place(vtkRenderer* renderer, const Layout& layout, double foreshortened, Rgb ink) {
  overlay_.emplace(renderer);
  if (look_.show_caption) {
    const std::string words = shortened(caption_, layout.caption.width / layout.font + 0.01);
    overlay_->text(words, layout.caption.x, middle(layout.caption), layout.font, Align::left, ink);
  }
  if (look_.show_clock)
    clock_ = overlay_->text("", layout.clock.right(), middle(layout.clock), layout.font, Align::right, ink);
  if (look_.show_ruler) place_ruler(layout, foreshortened, ink);
  place_key(layout, ink);
}

void Annotations::place_ruler(const Layout& layout, double foreshortened, Rgb ink) {
  const double x = layout.ruler.x, y = middle(layout.ruler), font = layout.font, line = layout.line;
  const double length = ruler_ * foreshortened * layout.scale;
  overlay_->box({x, y - line / 2, length, line}, ink);
  overlay_->box({x, y - 0.3 * font, line, 0.6 * font}, ink);
  overlay_->box({x + length - line, y - 0.3 * font, line, 0.6 * font}, ink);
  overlay_->text(metres(ruler_), x + length + 0.6 * font, y, font, Align::left, ink);
}

void Annotations::place_key(const Layout& layout, Rgb ink) {
  double x = layout.key.x;
  const double y = middle(layout.key), font = layout.font, radius = 0.32 * font;
  const auto entry = [&](const char* words, double inner, Rgb colour) {
    overlay_->ring(x + radius, y, inner, radius, colour);
    overlay_->text(words, x + mark * font, y, font, Align::left, ink);
    x += (mark + text_width(words) + between) * font;
  };
  if (keyed_surface()) entry(surface_words, 0.55 * radius, Particles::surface_colour);
  if (keyed_wall()) entry(wall_words, 0, Particles::wall_colour);
}

void Annotations::set_time(double seconds) {
  if (clock_) clock_->SetInput(clock_text(seconds).c_str());
}

}  // namespace seiche::render
