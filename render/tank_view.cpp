#include "render/tank_view.hpp"

#include <vtkActor.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "render/tank.hpp"

namespace seiche::render {

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

void set_background(vtkRenderer* renderer, const Look& look, Rgb paper) {
  if (look.background == "transparent") {
    renderer->SetBackground(0, 0, 0);  // with alpha 0, so that GL's blending leaves colours multiplied by their alpha
    renderer->SetBackgroundAlpha(0);
  } else {
    renderer->SetBackground(paper[0] / 255.0, paper[1] / 255.0, paper[2] / 255.0);
    renderer->SetBackgroundAlpha(1);
  }
}

TankView::TankView(vtkRenderer* renderer, const RunInfo& run, const Look& look, const Layout& layout,
                   const Palette& colours)
    : run_(run), moves_(look.view == "lab") {
  if (look.show_tank) {
    tank_.push_back(tank_outline(run, layout.line / layout.scale, colours.outline));
    if (run.dimension == 3) tank_.push_back(tank_back(run, colours.shade));
    for (const auto& part : tank_) renderer->AddActor(part);
  }
  particles_.emplace(renderer, run, look, layout.scale, std::max(1.2, 0.08 * layout.font));
}

void TankView::show(const Frame& frame, Range range) {
  const TankPose pose = moves_ ? frame.pose : TankPose{};
  particles_->show(frame, range, pose);
  for (const auto& part : tank_) {
    Double3 at = pose.displacement;
    if (run_.dimension == 2) at[2] = 0.5 * Particles::layer_height(run_);  // over the liquid, under the marks
    part->SetOrigin(pose.pivot[0], pose.pivot[1], 0);
    part->SetOrientation(0, 0, vtkMath::DegreesFromRadians(pose.roll));
    part->SetPosition(at.data());
  }
}

}  // namespace seiche::render
