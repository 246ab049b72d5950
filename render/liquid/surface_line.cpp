#include "render/liquid/surface_line.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <algorithm>

#include "render/liquid/particles.hpp"
#include "render/picture/pose.hpp"
#include "render/picture/tank_section.hpp"

namespace seiche::render {

struct SurfaceLine::Parts {
  vtkNew<vtkImageData> grid;
  vtkNew<vtkFloatArray> fraction;
  vtkNew<vtkFlyingEdges2D> contour;
  vtkNew<vtkPolyData> inside;
  vtkNew<vtkStripper> strips;
  vtkNew<vtkTubeFilter> tubes;
  vtkNew<vtkActor> actor;
  TankSection section;
  double layer;

  explicit Parts(const RunInfo& run) : section(run), layer(Particles::layer_height(run)) {}

  /// Of the contour what lies within the tank.
  void cut() {
    vtkPolyData* all = contour->GetOutput();
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkIdList> line;
    for (vtkIdType k = 0; k < all->GetNumberOfLines(); ++k) {
      all->GetLines()->GetCellAtId(k, line);
      const Eigen::Vector3d from(all->GetPoint(line->GetId(0))), to(all->GetPoint(line->GetId(1)));
      if (section.holds(0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]))) lines->InsertNextCell(line);
    }
    inside->SetPoints(all->GetPoints());
    inside->SetLines(lines);
    inside->Modified();
  }
};

SurfaceLine::SurfaceLine(vtkRenderer* renderer, const RunInfo& run, double font)
    : parts_(std::make_unique<Parts>(run)) {
  Parts& p = *parts_;
  p.grid->GetPointData()->SetScalars(p.fraction);
  p.contour->SetInputData(p.grid);
  p.contour->SetValue(0, SmoothField::surface);
  p.contour->ComputeScalarsOff();
  p.strips->SetInputData(p.inside);
  p.strips->JoinContiguousSegmentsOn();
  p.strips->SetMaximumLength(100000);
  p.tubes->SetInputConnection(p.strips->GetOutputPort());
  p.tubes->SetRadius(width * font / 2);
  p.tubes->SetNumberOfSides(6);
  p.tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(p.tubes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  p.actor->SetMapper(mapper);
  const Rgb colour = Particles::surface_colour;
  p.actor->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  p.actor->GetProperty()->LightingOff();
  renderer->AddActor(p.actor);
}

SurfaceLine::~SurfaceLine() = default;

void SurfaceLine::show(const SmoothField& field, const RigidState& pose) {
  Parts& p = *parts_;
  const auto count = static_cast<vtkIdType>(field.fraction().size());
  p.grid->SetDimensions(static_cast<int>(field.columns()), static_cast<int>(field.rows()), 1);
  p.grid->SetOrigin(field.left(), field.bottom(), 0);
  p.grid->SetSpacing(field.dx(), field.dy(), 1);
  p.fraction->SetNumberOfValues(count);
  std::copy(field.fraction().begin(), field.fraction().end(), p.fraction->GetPointer(0));
  p.fraction->Modified();
  p.grid->Modified();
  p.contour->Update();
  p.cut();
  p.actor->SetVisibility(p.inside->GetNumberOfLines() > 0);
  set_pose(p.actor, pose, p.layer);
}

}  // namespace seiche::render
