#include "render/panels/comparison.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "render/check_look.hpp"
#include "render/curves/curve_strip.hpp"
#include "render/gl/window.hpp"
#include "render/panels/compared_curves.hpp"
#include "render/panels/panel.hpp"
#include "render/panels/wording.hpp"
#include "render/picture/camera.hpp"
#include "render/picture/pixels.hpp"
#include "render/picture/range.hpp"
#include "render/picture/scalar_bar.hpp"
#include "render/picture/ticks.hpp"
#include "render/view/annotations.hpp"

namespace seiche::render {
namespace {

// What all panels show, so that they have one scale.
View view_of(const std::vector<Variant>& variants, const Look& look, const std::vector<PanelFrame>& frames) {
  Bounds all;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Bounds bounds = visible_bounds(variants[i].run, look, *frames[i].frame);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.low[axis] = std::min(all.low[axis], bounds.low[axis]);
      all.high[axis] = std::max(all.high[axis], bounds.high[axis]);
    }
  }
  return {variants.front().run.dimension, all};
}

// What the runs have in common.
std::string caption_of(const std::vector<Variant>& variants) {
  const RunInfo& first = variants.front().run;
  const auto common = [&](auto RunInfo::*member) {
    return std::all_of(variants.begin(), variants.end(),
                       [&](const Variant& variant) { return variant.run.*member == first.*member; });
  };
  std::string caption = common(&RunInfo::name) ? first.name : "";
  const auto add = [&](const std::string& words) { caption += (caption.empty() ? "" : " \u00b7 ") + words; };
  if (common(&RunInfo::kernel)) add(first.kernel);
  if (common(&RunInfo::spacing)) add(fmt::format("l\u2080 = {:.3g} mm", 1e3 * first.spacing));
  return caption;
}

}  // namespace

/// What stays between pictures.
struct Comparison::Pipeline {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> paper;  // under the panels, with all words
  std::optional<Annotations> words;
  std::vector<std::unique_ptr<Panel>> panels;
  std::optional<ScalarBar> bar;
  CurveStrip strip;
  Wording wording;
  PixelReader pixels;

  Pipeline(const std::vector<Variant>& variants, const Look& look, const std::vector<SensorCurve>& curves,
           const std::vector<PanelFrame>& frames, Range range);
};

Comparison::Pipeline::Pipeline(const std::vector<Variant>& variants, const Look& look,
                               const std::vector<SensorCurve>& curves, const std::vector<PanelFrame>& frames,
                               Range range)
    : strip(curves) {
  const Palette colours = palette_of_several(look.background);
  const Quantity quantity = look.quantity;
  const View view = view_of(variants, look, frames);
  RunInfo longest = variants.front().run;
  for (const Variant& variant : variants) longest.end = std::max(longest.end, variant.run.end);
  words.emplace(longest, look, caption_of(variants), round_below(0.25 * view.width()));
  Needs needs{.width = look.width, .height = look.height, .view_width = view.width(), .view_height = view.height()};
  words->reserve(needs, view.foreshortening());
  if (look.show_bar) {
    needs.bar_labels = ScalarBar::label_width(quantity, range);
    needs.bar_title = text_width(title_of(quantity));
  }
  strip.reserve(needs);
  const auto [layout, worded] = worded_layout(needs, variants, measured(curves));
  wording = worded;
  if (layout.panels.front().view.width < 8 || layout.panels.front().view.height < 8)
    throw std::invalid_argument(fmt::format("a picture of {} x {} pixels is too small for {} panels", look.width,
                                            look.height, variants.size()));

  window = make_window(sharpness * look.width, sharpness * look.height);
  window->SetAlphaBitPlanes(1);
  window->SetNumberOfLayers(2);
  window->AddRenderer(paper);
  set_background(paper, look, colours.background);
  double finest = longest.spacing;
  for (const Variant& variant : variants) finest = std::min(finest, variant.run.spacing);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    Variant variant = variants[i];
    if (wording.brief_labels) variant.label = brief(variant.label);
    panels.push_back(std::make_unique<Panel>(window, paper, variant, i, look, view, layout, colours, finest));
  }
  if (look.show_bar) bar.emplace(paper, layout.around, quantity, ColourMap(look.colour_map), colours.foreground);
  words->place(paper, layout.around, view.foreshortening(),
               arrow_font(layout.panels.front().view.width, layout.around.font), colours.foreground);
  strip.place(paper, layout.around, colours);
}

Comparison::Comparison(std::vector<Variant> variants, const Look& look) : variants_(std::move(variants)), look_(look) {
  check_look(look_);
  if (variants_.empty() || variants_.size() > most_panels)
    throw std::invalid_argument(
        fmt::format("{} runs in one picture; it has room for 1 to {}", variants_.size(), most_panels));
  for (const Variant& variant : variants_)
    if (variant.run.dimension != variants_.front().run.dimension)
      throw std::invalid_argument("a 2-D and a 3-D run can't share a picture");
  curves_ = compared_curves(variants_, look_);
}

Comparison::~Comparison() = default;

void Comparison::record(std::size_t variant, const Readings& readings) {
  for (SensorCurve& curve : curves_)
    if (curve.traces[variant].column < variants_[variant].run.sensors.size()) render::record(curve, readings, variant);
}

Image Comparison::draw(double time, const std::vector<PanelFrame>& frames, Range range) {
  if (!pipeline_) {
    settle(curves_);
    pipeline_ = std::make_unique<Pipeline>(variants_, look_, curves_, frames, range);
  }
  Range found{range.high, range.low};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    pipeline_->panels[i]->show(frames[i], range,
                               variants_[i].failed ? "" : note_of(measured(curves_), i, time, pipeline_->wording));
    if (frames[i].ended) continue;
    const Range pressures = fluid_range(*frames[i].frame, look_.quantity);
    found = {std::min(found.low, pressures.low), std::max(found.high, pressures.high)};
  }
  if (pipeline_->bar) pipeline_->bar->show(range, found);
  pipeline_->words->set_time(time);
  pipeline_->strip.show(time);
  pipeline_->window->Render();
  return pipeline_->pixels.read(pipeline_->window);
}

}  // namespace seiche::render
