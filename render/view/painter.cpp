#include "render/view/painter.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <optional>
#include <stdexcept>

#include "render/check_look.hpp"
#include "render/curves/curve_strip.hpp"
#include "render/gl/window.hpp"
#include "render/picture/camera.hpp"
#include "render/picture/layout.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/pixels.hpp"
#include "render/picture/range.hpp"
#include "render/picture/scalar_bar.hpp"
#include "render/picture/ticks.hpp"
#include "render/view/annotations.hpp"
#include "render/view/mark_shapes.hpp"
#include "render/view/tank_view.hpp"

namespace seiche::render {

/// What stays between frames.
struct Painter::Pipeline {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  std::optional<Annotations> words;
  std::optional<TankView> tank;
  std::optional<ScalarBar> bar;
  std::optional<Overlay> marked;
  CurveStrip strip;
  PixelReader pixels;

  Pipeline(const RunInfo& run, const Look& look, const std::vector<SensorCurve>& curves, const MotionMarks& marks,
           const Frame& first);
};

Painter::Pipeline::Pipeline(const RunInfo& run, const Look& look, const std::vector<SensorCurve>& curves,
                            const MotionMarks& marks, const Frame& first)
    : strip(curves) {
  const Palette colours = palette(look.background);
  const Quantity quantity = look.quantity;
  const double arrow = mark_length({run.tank.low(), run.tank.high()});
  const View view(run.dimension, with_marks(visible_bounds(run, look, first), marks, arrow));
  words.emplace(run, look, caption_of(run), round_below(0.25 * view.width()));

  Needs needs{.width = look.width, .height = look.height, .view_width = view.width(), .view_height = view.height()};
  words->reserve(needs, view.foreshortening());
  if (look.show_bar) {
    needs.bar_labels = ScalarBar::label_width(quantity, fixed_range(run, look).value_or(scene_range(run, quantity)));
    needs.bar_title = text_width(title_of(quantity));
  }
  strip.reserve(needs);
  const Layout layout = lay_out(needs);
  if (!(layout.scale > 0))
    throw std::invalid_argument(fmt::format("a picture of {} x {} pixels is too small", look.width, look.height));

  window = make_window(sharpness * look.width, sharpness * look.height);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer);
  set_background(renderer, look, colours.background);
  view.aim(renderer, layout, look.width, look.height);
  tank.emplace(renderer, run, look, layout, colours, run.spacing);
  if (look.show_bar) bar.emplace(renderer, layout, quantity, ColourMap(look.colour_map), colours.foreground);
  words->place(renderer, layout, view.foreshortening(), arrow_font(layout.view.width, layout.font), colours.foreground);
  strip.place(renderer, layout, colours);
  if (marks.marks.empty()) return;
  marked.emplace(renderer);
  draw_marks(*marked, marks, arrow, view, layout, look.width, colours);
}

Painter::Painter(const RunInfo& run, const Look& look) : run_(run), look_(look) {
  check_look(look);
  check_dimension(look, run.dimension);
  curves_ = sensor_curves(run, look);
}
Painter::~Painter() = default;

void Painter::record(const Readings& readings) {
  for (SensorCurve& curve : curves_) render::record(curve, readings);
}

Image Painter::draw(const Frame& frame, Range range) {
  if (!pipeline_) pipeline_ = std::make_unique<Pipeline>(run_, look_, curves_, marks_, frame);
  pipeline_->tank->show(frame, range);
  if (pipeline_->bar) pipeline_->bar->show(range, fluid_range(frame, look_.quantity));
  pipeline_->words->set_time(frame.time);
  pipeline_->strip.show(frame.time);
  pipeline_->window->Render();
  return pipeline_->pixels.read(pipeline_->window);
}

}  // namespace seiche::render
