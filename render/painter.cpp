#include "render/painter.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "render/camera.hpp"
#include "render/particles.hpp"
#include "render/pixels.hpp"
#include "render/scalar_bar.hpp"
#include "render/tank.hpp"
#include "render/window.hpp"

namespace seiche::render {
namespace {

struct Palette {
  Rgb paper, ink, outline, shade;
};

Palette palette(const std::string& background) {
  if (background == "black") return {{0, 0, 0}, {232, 232, 232}, {214, 214, 214}, {30, 31, 33}};
  return {{255, 255, 255}, {34, 34, 34}, {64, 64, 64}, {240, 241, 243}};
}

// Everything that any frame may show: the tank with the layers of its wall, and in the lab's view where it sways to.
Bounds room_of(const RunInfo& run, const Look& look, const Frame& first) {
  Bounds room{{0, 0, 0}, run.tank};
  if (look.show_walls && run.dimension == 2)
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first.kind[i] == Kind::fluid) continue;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        room.low[axis] = std::min(room.low[axis], first.position[i][axis] - run.spacing / 2);
        room.high[axis] = std::max(room.high[axis], first.position[i][axis] + run.spacing / 2);
      }
    }
  if (look.view == "lab")
    for (std::size_t axis = 0; axis < 3; ++axis) {
      room.low[axis] -= std::abs(run.sway[axis]);
      room.high[axis] += std::abs(run.sway[axis]);
    }
  return room;
}

std::string millimetres(double metres) { return fmt::format("{:.3g} mm", 1e3 * metres); }
std::string metres(double metres) { return fmt::format("{:.3g} m", metres); }
std::string clock_text(double time) { return fmt::format("t = {:.3f} s", time); }

std::string caption_text(const RunInfo& run) {
  return fmt::format("{} \u00b7 {} \u00b7 l0 = {}", run.name, run.kernel, millimetres(run.spacing));
}

// Cut at the end, between characters, until it fits.
std::string shortened(std::string words, double room) {
  if (text_width(words) <= room) return words;
  while (!words.empty() && text_width(words + "\u2026") > room) {
    while (!words.empty() && (words.back() & 0xc0) == 0x80) words.pop_back();
    if (!words.empty()) words.pop_back();
  }
  return words + "\u2026";
}

}  // namespace

/// What stays between frames.
struct Painter::Stage {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  std::optional<Particles> particles;
  std::optional<Overlay> overlay;
  std::optional<ScalarBar> bar;
  std::vector<vtkSmartPointer<vtkActor>> tank;
  vtkTextActor* clock = nullptr;  // owned by the overlay
  PixelReader pixels;

  Stage(const RunInfo& run, const Look& look, const Frame& first);
  void key(const RunInfo& run, const Look& look, const Box& place, double font, Rgb ink);
  void ruler(const Box& place, const std::string& label, double length, double line, Rgb ink);
};

Painter::Stage::Stage(const RunInfo& run, const Look& look, const Frame& first) {
  const Palette colours = palette(look.background);
  const View view(run.dimension, room_of(run, look, first));
  const double ruler_length = round_below(0.25 * view.width());
  const double drawn_ruler = ruler_length * view.foreshortening();

  Needs needs;
  needs.width = look.width;
  needs.height = look.height;
  needs.view_width = view.width();
  needs.view_height = view.height();
  if (look.show_caption) needs.caption = text_width(caption_text(run));
  if (look.show_clock) needs.clock = text_width(clock_text(-std::max(run.end, 1.0)));
  if (look.show_surface) needs.key += 1 + text_width("free surface");
  if (look.show_walls && run.dimension == 2) needs.key += (needs.key > 0 ? 1.2 : 0) + 1 + text_width("wall");
  if (look.show_ruler) needs.ruler = drawn_ruler, needs.ruler_label = text_width(metres(ruler_length));
  if (look.show_bar) {
    const Range range = parse_range(look.range).value_or(scene_range(run));
    needs.bar_labels = ScalarBar::label_width(range);
    needs.bar_title = text_width(ScalarBar::title);
  }
  const Layout layout = lay_out(needs);
  if (!(layout.scale > 0))
    throw std::invalid_argument(fmt::format("a picture of {} x {} pixels is too small", look.width, look.height));

  window = make_window(sharpness * look.width, sharpness * look.height);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer);
  renderer->SetBackground(colours.paper[0] / 255.0, colours.paper[1] / 255.0, colours.paper[2] / 255.0);
  renderer->SetBackgroundAlpha(1);
  if (look.background == "transparent") {
    renderer->SetBackground(0, 0, 0);  // with alpha 0, so that GL's blending leaves colours multiplied by their alpha
    renderer->SetBackgroundAlpha(0);
  }
  view.aim(renderer, layout, look.width, look.height);

  if (look.show_tank) {
    tank.push_back(tank_outline(run, layout.line / layout.scale, colours.outline));
    if (run.dimension == 3) tank.push_back(tank_back(run, colours.shade));
    for (const auto& part : tank) renderer->AddActor(part);
  }
  particles.emplace(renderer, run, look, layout.scale, std::max(1.2, 0.08 * layout.font));
  overlay.emplace(renderer);
  if (look.show_bar) bar.emplace(renderer, layout, ColourMap(look.colour_map), colours.ink);
  const auto words = [&](const std::string& text, const Box& place, Align align) {
    const double x = align == Align::left ? place.x : place.right();
    return overlay->text(text, x, place.y + place.height / 2, layout.font, align, colours.ink);
  };
  if (look.show_caption)
    words(shortened(caption_text(run), layout.caption.width / layout.font), layout.caption, Align::left);
  if (look.show_clock) clock = words("", layout.clock, Align::right);
  if (look.show_ruler) ruler(layout.ruler, metres(ruler_length), drawn_ruler * layout.scale, layout.line, colours.ink);
  key(run, look, layout.key, layout.font, colours.ink);
}

void Painter::Stage::ruler(const Box& place, const std::string& label, double length, double line, Rgb ink) {
  const double middle = place.y + place.height / 2, font = place.height;
  overlay->box({place.x, middle - line / 2, length, line}, ink);
  overlay->box({place.x, middle - 0.3 * font, line, 0.6 * font}, ink);
  overlay->box({place.x + length - line, middle - 0.3 * font, line, 0.6 * font}, ink);
  overlay->text(label, place.x + length + 0.6 * font, middle, font, Align::left, ink);
}

void Painter::Stage::key(const RunInfo& run, const Look& look, const Box& place, double font, Rgb ink) {
  double x = place.x;
  const double y = place.y + place.height / 2, radius = 0.32 * font;
  const auto entry = [&](const char* words, double inner, Rgb colour) {
    overlay->ring(x + radius, y, inner, radius, colour);
    overlay->text(words, x + font, y, font, Align::left, ink);
    x += (1 + text_width(words) + 1.2) * font;
  };
  if (look.show_surface) entry("free surface", 0.55 * radius, Particles::surface_colour);
  if (look.show_walls && run.dimension == 2) entry("wall", 0, Particles::wall_colour);
}

Painter::Painter(const RunInfo& run, const Look& look) : run_(run), look_(look) { check_look(look); }
Painter::~Painter() = default;

Image Painter::draw(const Frame& frame, Range range) {
  if (!stage_) stage_ = std::make_unique<Stage>(run_, look_, frame);
  Double3 shift = look_.view == "lab" ? frame.pose.displacement : Double3{};
  stage_->particles->show(frame, range, shift);
  for (const auto& part : stage_->tank) {
    Double3 at = shift;
    if (run_.dimension == 2) at[2] = 0.5 * Particles::layer_height(run_);  // over the liquid, under the marks
    part->SetPosition(at.data());
  }
  if (stage_->bar) stage_->bar->show(range, fluid_range(frame));
  if (stage_->clock) stage_->clock->SetInput(clock_text(frame.time).c_str());
  stage_->window->Render();
  return stage_->pixels.read(stage_->window);
}

void check_look(const Look& look) {
  const auto among = [](const char* key, const std::string& value, std::initializer_list<const char*> names) {
    if (std::find(names.begin(), names.end(), value) != names.end()) return;
    std::string all;
    for (const char* name : names) all += all.empty() ? name : fmt::format(", {}", name);
    throw std::invalid_argument(fmt::format("'{}' is no {}; choose one of {}", value, key, all));
  };
  if (look.width < 64 || look.height < 64 || look.width > 8192 || look.height > 8192)
    throw std::invalid_argument(
        fmt::format("{} x {} is no size for a picture; give 64 to 8192 pixels each way", look.width, look.height));
  ColourMap{look.colour_map};
  among("background", look.background, {"white", "black", "transparent"});
  among("style", look.style, {"disc", "dot"});
  among("view", look.view, {"tank", "lab"});
  parse_range(look.range);
}

}  // namespace seiche::render
