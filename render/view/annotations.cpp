#include "render/view/annotations.hpp"

#include <fmt/format.h>
#include <vtkTextActor.h>

#include <algorithm>

#include "render/liquid/arrow.hpp"
#include "render/liquid/arrow_scale.hpp"
#include "render/liquid/arrows.hpp"
#include "render/liquid/particles.hpp"
#include "render/liquid/surface_line.hpp"
#include "render/liquid/surface_mark.hpp"
#include "render/picture/layout.hpp"
#include "render/picture/quantity.hpp"

namespace seiche::render {
namespace {

constexpr const char *surface_words = "free surface", *wall_words = "wall";
constexpr double mark = 1, between = 1.2, after_arrow = 0.5;  // widths in the key, in font heights

std::string metres(double length) { return fmt::format("{:.3g} m", length); }
std::string speed_text(double speed) { return fmt::format("{:.3g} m/s", speed); }
std::string clock_text(double seconds) { return fmt::format("t = {:.3f} s", seconds); }

double middle(const Box& box) { return box.y + box.height / 2; }

}  // namespace

std::string caption_of(const RunInfo& run) {
  return fmt::format("{} \u00b7 {} \u00b7 l\u2080 = {:.3g} mm", run.name, run.kernel, 1e3 * run.spacing);
}

// What the colours tell needs no second word.
bool Annotations::keyed_wall() const {
  return look_.show_walls && run_.dimension == 2 && look_.quantity != Quantity::kind;
}

double Annotations::marks_width() const {
  double width = 0;
  if (surface_mark(look_) != SurfaceMark::none) width += mark + text_width(surface_words);
  if (keyed_wall()) width += (width > 0 ? between : 0) + mark + text_width(wall_words);
  return width;
}

double Annotations::arrow_width() const {
  const ArrowScale scale = arrow_scale(run_, look_);
  return scale.length * scale.reference + after_arrow + text_width(speed_text(scale.reference));
}

// Where there is room for it.
bool Annotations::keyed_arrow() const {
  const double room = look_.width / font_height({.width = look_.width, .height = look_.height}) - 2 * layout_pad;
  return look_.show_arrows && marks_width() + between + arrow_width() <= room;
}

void Annotations::reserve(Needs& needs, double foreshortened) const {
  if (look_.show_caption) needs.caption = text_width(caption_);
  if (look_.show_clock) needs.clock = text_width(clock_text(std::max(run_.end, 1.0)));
  needs.key = marks_width();
  if (keyed_arrow()) needs.key += (needs.key > 0 ? between : 0) + arrow_width();
  if (look_.show_ruler) {
    needs.ruler = ruler_ * foreshortened;
    needs.ruler_label = text_width(metres(ruler_));
  }
}

void Annotations::place(vtkRenderer* renderer, const Layout& layout, double foreshortened, double arrow_font,
                        Rgb foreground) {
  overlay_.emplace(renderer);
  if (look_.show_caption) {
    const std::string words = shortened(caption_, layout.caption.width / layout.font + 0.01);
    overlay_->text(words, layout.caption.x, middle(layout.caption), layout.font, Align::left, foreground);
  }
  if (look_.show_clock)
    clock_ = overlay_->text("", layout.clock.right(), middle(layout.clock), layout.font, Align::right, foreground);
  if (look_.show_ruler) place_ruler(layout, foreshortened, foreground);
  place_key(layout, arrow_font, foreground);
}

void Annotations::place_ruler(const Layout& layout, double foreshortened, Rgb foreground) {
  const double x = layout.ruler.x, y = middle(layout.ruler), font = layout.font, line = layout.line;
  const double length = ruler_ * foreshortened * layout.scale;
  overlay_->box({x, y - line / 2, length, line}, foreground);
  overlay_->box({x, y - 0.3 * font, line, 0.6 * font}, foreground);
  overlay_->box({x + length - line, y - 0.3 * font, line, 0.6 * font}, foreground);
  overlay_->text(metres(ruler_), x + length + 0.6 * font, y, font, Align::left, foreground);
}

void Annotations::place_key(const Layout& layout, double arrow_font, Rgb foreground) {
  double x = layout.key.x;
  const double y = middle(layout.key), font = layout.font, radius = 0.32 * font;
  const auto entry = [&](const char* words) {
    overlay_->text(words, x + mark * font, y, font, Align::left, foreground);
    x += (mark + text_width(words) + between) * font;
  };
  if (keyed_arrow()) {
    const ArrowScale scale = arrow_scale(run_, look_);
    const double length = scale.length * scale.reference * arrow_font, room = scale.length * scale.reference * font;
    const ArrowShape arrow = placed(arrow_shape(length, arrow_font), {x + room - length / 2, y}, {1, 0});
    for (const Line& halo : {arrow.shaft_halo, arrow.head_halo}) overlay_->polygon(halo, Arrows::halo);
    for (const Line& dark : {arrow.shaft, arrow.head}) overlay_->polygon(dark, Arrows::foreground);
    overlay_->text(speed_text(scale.reference), x + room + after_arrow * font, y, font, Align::left, foreground);
    x += (arrow_width() + between) * font;
  }
  const SurfaceMark sign = surface_mark(look_);
  if (sign == SurfaceMark::rings) overlay_->ring(x + radius, y, 0.55 * radius, radius, Particles::surface_colour);
  if (sign == SurfaceMark::line)
    overlay_->box({x, y - SurfaceLine::width * font / 2, 2 * radius, SurfaceLine::width * font},
                  Particles::surface_colour);
  if (sign != SurfaceMark::none) entry(surface_words);
  if (keyed_wall()) {
    overlay_->ring(x + radius, y, 0, radius, Particles::wall_colour);
    entry(wall_words);
  }
}

void Annotations::set_time(double seconds) {
  if (clock_) clock_->SetInput(clock_text(seconds).c_str());
}

}  // namespace seiche::render
