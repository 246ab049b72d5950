#include "render/liquid/wall_squares.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "render/picture/pose.hpp"
#include "render/picture/tank_section.hpp"

namespace seiche::render {
namespace {

/// Wider than a spacing, for layers whose particles stand a little farther apart.
constexpr double overlap = 1.06;

}  // namespace

struct WallSquares::Parts {
  TankSection section;
  double spacing, layer;
  Rgb wall, dummy;
  bool filled = false;
  vtkNew<vtkPolyData> squares;
  vtkNew<vtkActor> actor;
};

WallSquares::WallSquares(vtkRenderer* renderer, const RunInfo& run, double layer, Rgb wall, Rgb dummy)
    : parts_(new Parts{TankSection(run), run.spacing, layer, wall, dummy, false, {}, {}}) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(parts_->squares);
  parts_->actor->SetMapper(mapper);
  parts_->actor->GetProperty()->LightingOff();
  renderer->AddActor(parts_->actor);
}

WallSquares::~WallSquares() = default;

void WallSquares::show(const Frame& frame, const RigidState& pose) {
  Parts& p = *parts_;
  set_pose(p.actor, pose, 0);
  if (p.filled) return;
  p.filled = true;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Eigen::Vector2d r(frame.position[i][0], frame.position[i][1]);
    if (frame.kind[i] == Kind::fluid || p.section.holds(r[0], r[1])) continue;
    const bool wall = frame.kind[i] == Kind::wall;
    const Eigen::Vector2d across = 0.5 * p.spacing * p.section.nearest_normal(r);
    const Eigen::Vector2d along = overlap * Eigen::Vector2d(-across[1], across[0]);
    cells->InsertNextCell(4);
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const Eigen::Vector2d corner = r + u * along + v * across;
      cells->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], (wall ? -1 : -2) * p.layer));
    }
    colours->InsertNextTypedTuple((wall ? p.wall : p.dummy).data());
  }
  p.squares->SetPoints(points);
  p.squares->SetPolys(cells);
  p.squares->GetCellData()->SetScalars(colours);
}

}  // namespace seiche::render
