#include "render/picture/scalar_bar.hpp"

#include <fmt/format.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <algorithm>

#include "render/picture/axis.hpp"
#include "render/picture/ticks.hpp"

namespace seiche::render {
namespace {

constexpr double label_font = 0.88;  // of the layout's font

// "max 3120" where the frame goes beyond the range by more than can be taken for rounding.
std::string beyond(const char* what, double value, double excess, Range range) {
  if (excess <= 0.01 * (range.high - range.low)) return "";
  return fmt::format("{} {}", what, tick_label(value, round_ticks(range).step));
}

}  // namespace

ScalarBar::ScalarBar(vtkRenderer* renderer, const Layout& layout, Quantity quantity, const ColourMap& map,
                     Rgb foreground)
    : overlay_(renderer), layout_(layout), quantity_(quantity), map_(map), foreground_(foreground) {}

double ScalarBar::label_width(Quantity quantity, Range range) {
  double width = 0;
  for (const Class& each : classes_of(quantity)) width = std::max(width, label_font * text_width(each.name));
  if (width > 0) return width;
  return label_font * (render::label_width(axis_of(range)) + text_width("max 0"));
}

std::array<double, 2> ScalarBar::at(double along, double across) const {
  const Box& bar = layout_.bar;
  if (layout_.bar_upright) return {bar.x + across, bar.y + along * bar.height};
  return {bar.x + along * bar.width, bar.top() - across};
}

void ScalarBar::draw_colours() {
  constexpr int parts = 128;
  const double thick = layout_.bar_upright ? layout_.bar.width : layout_.bar.height;
  const double point = 0.9 * layout_.font / (layout_.bar_upright ? layout_.bar.height : layout_.bar.width);
  for (int part = 0; part < parts; ++part) {
    const double low = static_cast<double>(part) / parts, high = static_cast<double>(part + 1) / parts;
    overlay_.polygon({at(low, 0), at(low, thick), at(high, thick), at(high, 0)}, map_((low + high) / 2));
  }
  overlay_.polygon({at(0, 0), at(0, thick), at(-point, thick / 2)}, map_(0));
  overlay_.polygon({at(1, 0), at(1, thick), at(1 + point, thick / 2)}, map_(1));
}

void ScalarBar::draw_ticks() {
  const double f = layout_.font, half = layout_.line / 2;
  const double side = layout_.bar_upright ? layout_.bar.width : layout_.bar.height;
  const auto words = [&](const std::string& text, std::array<double, 2> place, Align align) {
    return overlay_.text(text, place[0], place[1], label_font * f, align, foreground_);
  };
  const Axis axis = axis_of(*range_);
  for (const Tick& tick : axis.ticks) {
    const double along = axis.along(tick.position);
    const auto [x, y] = at(along, side);
    if (layout_.bar_upright)
      overlay_.box({x, y - half, 0.3 * f, 2 * half}, foreground_);
    else
      overlay_.box({x - half, y - 0.3 * f, 2 * half, 0.3 * f}, foreground_);
    if (layout_.bar_upright)
      words(tick.label, at(along, side + 0.55 * f), Align::left);
    else
      words(tick.label, at(along, side + 0.95 * f), Align::centre);
  }
  const Box& bar = layout_.bar;
  if (layout_.bar_upright) {
    above_ = words("", {bar.x + side + 0.55 * f, bar.top() + 1.0 * f}, Align::left);
    below_ = words("", {bar.x + side + 0.55 * f, bar.y - 1.0 * f}, Align::left);
  } else {
    above_ = words("", {bar.right() + 1.3 * f, bar.y + bar.height / 2}, Align::left);
    below_ = words("", {bar.x - 1.3 * f, bar.y + bar.height / 2}, Align::right);
  }
}

void ScalarBar::draw_title() {
  const Box& bar = layout_.bar;
  const double f = layout_.font;
  if (layout_.bar_upright)
    overlay_.text(title_of(quantity_), bar.x, bar.top() + 2.5 * f, f, Align::left, foreground_);
  else
    overlay_.text(title_of(quantity_), bar.x + bar.width / 2, bar.top() + 0.9 * f, f, Align::centre, foreground_);
}

void ScalarBar::draw_classes() {
  const auto& classes = classes_of(quantity_);
  const double f = layout_.font, parts = static_cast<double>(classes.size());
  const double thick = layout_.bar_upright ? layout_.bar.width : layout_.bar.height;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const double low = static_cast<double>(k) / parts, high = static_cast<double>(k + 1) / parts;
    overlay_.polygon({at(low, 0), at(low, thick), at(high, thick), at(high, 0)}, classes[k].colour);
    const auto [x, y] = at((low + high) / 2, thick + (layout_.bar_upright ? 0.55 : 0.95) * f);
    overlay_.text(classes[k].name, x, y, label_font * f, layout_.bar_upright ? Align::left : Align::centre,
                  foreground_);
  }
}

void ScalarBar::show(Range range, Range found) {
  if (!range_ || range_->low != range.low || range_->high != range.high) {
    range_ = range;
    overlay_.clear();
    draw_title();
    if (classes_of(quantity_).empty()) {
      draw_colours();
      draw_ticks();
    } else {
      draw_classes();
    }
  }
  if (!below_) return;
  below_->SetInput(beyond("min", found.low, range.low - found.low, range).c_str());
  above_->SetInput(beyond("max", found.high, found.high - range.high, range).c_str());
}

}  // namespace seiche::render
