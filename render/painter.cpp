#include "render/painter.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "render/annotations.hpp"
#include "render/camera.hpp"
#include "render/curve_strip.hpp"
#include "render/palette.hpp"
#include "render/particles.hpp"
#include "render/pixels.hpp"
#include "render/scalar_bar.hpp"
#include "render/tank.hpp"
#include "render/window.hpp"

namespace seiche::render {
namespace {

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

}  // namespace

/// What stays between frames.
struct Painter::Stage {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  std::optional<Annotations> words;
  std::optional<Particles> particles;
  std::optional<ScalarBar> bar;
  CurveStrip strip;
  std::vector<vtkSmartPointer<vtkActor>> tank;
  PixelReader pixels;

  Stage(const RunInfo& run, const Look& look, const std::vector<SensorCurve>& curves, const Frame& first);
  void set_background(const Look& look, Rgb paper);
};

Painter::Stage::Stage(const RunInfo& run, const Look& look, const std::vector<SensorCurve>& curves, const Frame& first)
    : strip(curves) {
  const Palette colours = palette(look.background);
  const Quantity quantity = quantity_of(look.quantity);
  const View view(run.dimension, room_of(run, look, first));
  words.emplace(run, look, round_below(0.25 * view.width()));

  Needs needs{.width = look.width, .height = look.height, .view_width = view.width(), .view_height = view.height()};
  words->claim(needs, view.foreshortening());
  if (look.show_bar) {
    needs.bar_labels = ScalarBar::label_width(quantity, fixed_range(run, look).value_or(scene_range(run, quantity)));
    needs.bar_title = text_width(title_of(quantity));
  }
  strip.claim(needs);
  const Layout layout = lay_out(needs);
  if (!(layout.scale > 0))
    throw std::invalid_argument(fmt::format("a picture of {} x {} pixels is too small", look.width, look.height));

  window = make_window(sharpness * look.width, sharpness * look.height);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer);
  set_background(look, colours.paper);
  view.aim(renderer, layout, look.width, look.height);
  if (look.show_tank) {
    tank.push_back(tank_outline(run, layout.line / layout.scale, colours.outline));
    if (run.dimension == 3) tank.push_back(tank_back(run, colours.shade));
    for (const auto& part : tank) renderer->AddActor(part);
  }
  particles.emplace(renderer, run, look, layout.scale, std::max(1.2, 0.08 * layout.font));
  if (look.show_bar) bar.emplace(renderer, layout, quantity, ColourMap(look.colour_map), colours.ink);
  words->place(renderer, layout, view.foreshortening(), colours.ink);
  strip.place(renderer, layout, colours);
}

void Painter::Stage::set_background(const Look& look, Rgb paper) {
  if (look.background == "transparent") {
    renderer->SetBackground(0, 0, 0);  // with alpha 0, so that GL's blending leaves colours multiplied by their alpha
    renderer->SetBackgroundAlpha(0);
  } else {
    renderer->SetBackground(paper[0] / 255.0, paper[1] / 255.0, paper[2] / 255.0);
    renderer->SetBackgroundAlpha(1);
  }
}

Painter::Painter(const RunInfo& run, const Look& look) : run_(run), look_(look) {
  check_look(look);
  curves_ = sensor_curves(run, look);
}
Painter::~Painter() = default;

void Painter::record(const Readings& readings) {
  for (SensorCurve& curve : curves_) render::record(curve, readings);
}

Image Painter::draw(const Frame& frame, Range range) {
  if (!stage_) stage_ = std::make_unique<Stage>(run_, look_, curves_, frame);
  const TankPose pose = look_.view == "lab" ? frame.pose : TankPose{};
  stage_->particles->show(frame, range, pose);
  for (const auto& part : stage_->tank) {
    Double3 at = pose.displacement;
    if (run_.dimension == 2) at[2] = 0.5 * Particles::layer_height(run_);  // over the liquid, under the marks
    part->SetOrigin(pose.pivot[0], pose.pivot[1], 0);
    part->SetOrientation(0, 0, vtkMath::DegreesFromRadians(pose.roll));
    part->SetPosition(at.data());
  }
  if (stage_->bar) stage_->bar->show(range, fluid_range(frame, quantity_of(look_.quantity)));
  stage_->words->set_time(frame.time);
  stage_->strip.show(frame.time);
  stage_->window->Render();
  return stage_->pixels.read(stage_->window);
}

}  // namespace seiche::render
