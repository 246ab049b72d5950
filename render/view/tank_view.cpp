#include "render/view/tank_view.hpp"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

#include "render/liquid/surface_mark.hpp"
#include "render/picture/pose.hpp"
#include "render/picture/tank.hpp"

namespace seiche::render {

Bounds visible_bounds(const RunInfo& run, const Look& look, const Frame& first) {
  Bounds bounds{run.tank.low(), run.tank.high()};
  if (look.show_walls && run.dimension == 2)
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first.kind[i] == Kind::fluid) continue;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        bounds.low[axis] = std::min(bounds.low[axis], first.position[i][axis] - run.spacing / 2);
        bounds.high[axis] = std::max(bounds.high[axis], first.position[i][axis] + run.spacing / 2);
      }
    }
  if (look.view == ReferenceFrame::lab)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.low[axis] -= std::abs(run.excursion[axis]);
      bounds.high[axis] += std::abs(run.excursion[axis]);
    }
  return bounds;
}

void set_background(vtkRenderer* renderer, const Look& look, Rgb paper) {
  if (look.background == Background::transparent) {
    renderer->SetBackground(0, 0, 0);  // with alpha 0, so that GL's blending leaves colours multiplied by their alpha
    renderer->SetBackgroundAlpha(0);
  } else {
    renderer->SetBackground(paper[0] / 255.0, paper[1] / 255.0, paper[2] / 255.0);
    renderer->SetBackgroundAlpha(1);
  }
}

TankView::TankView(vtkRenderer* renderer, const RunInfo& run, const Look& look, const Layout& layout,
                   const Palette& colours, double finest)
    : run_(run), moves_(look.view == ReferenceFrame::lab), quantity_(look.quantity) {
  if (look.show_tank) {
    tank_.push_back(tank_outline(run, layout.line / layout.scale, colours.outline));
    if (run.dimension == 3) tank_.push_back(tank_back(run, colours.shade));
    for (const auto& part : tank_) renderer->AddActor(part);
  }
  particles_.emplace(renderer, run, look, layout.scale, std::max(1.2, 0.08 * layout.font), finest);
  const bool smooth = look.style == Style::smooth, lined = surface_mark(look) == SurfaceMark::line;
  if (smooth || lined) field_.emplace(run, std::max(0.25 * run.spacing, 1 / layout.scale));
  if (smooth) liquid_.emplace(renderer, run, *field_, ColourMap(look.colour_map));
  if (lined) surface_.emplace(renderer, run, layout.font / layout.scale);
  if (look.show_arrows)
    arrows_.emplace(renderer, run, arrow_scale(run, look), layout.scale, arrow_font(layout.view.width, layout.font));
}

TankView::~TankView() = default;

void TankView::show(const Frame& frame, Range range) {
  const RigidState pose = moves_ ? frame.pose : RigidState{};
  if (field_) field_->take(frame, quantity_);
  if (liquid_) liquid_->show(*field_, range, pose);
  if (surface_) surface_->show(*field_, pose);
  particles_->show(frame, range, pose, liquid_ ? &*field_ : nullptr);
  if (arrows_) arrows_->show(frame, pose);
  // In 2-D over the liquid, under the marks.
  const double height = run_.dimension == 2 ? 0.5 * Particles::layer_height(run_) : 0;
  for (const auto& part : tank_) set_pose(part, pose, height);
}

}  // namespace seiche::render
