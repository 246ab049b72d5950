#include "render/liquid/surface_line.hpp"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <algorithm>

#include "render/liquid/particles.hpp"
#include "render/picture/pose.hpp"

namespace seiche::render {

struct SurfaceLine::Parts {
  vtkNew<vtkImageData> grid;
  vtkNew<vtkFloatArray> fraction;
  vtkNew<vtkFlyingEdges2D> contour;
  vtkNew<vtkStripper> strips;
  vtkNew<vtkTubeFilter> tubes;
  vtkNew<vtkActor> actor;
  double layer = 0;
};

SurfaceLine::SurfaceLine(vtkRenderer* renderer, const RunInfo& run, double font) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.layer = Particles::layer_height(run);
  p.grid->GetPointData()->SetScalars(p.fraction);
  p.contour->SetInputData(p.grid);
  p.contour->SetValue(0, SmoothField::surface);
  p.contour->ComputeScalarsOff();
  p.strips->SetInputConnection(p.contour->GetOutputPort());
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

void SurfaceLine::show(const SmoothField& field, const TankPose& pose) {
  Parts& p = *parts_;
  const auto count = static_cast<vtkIdType>(field.fraction().size());
  p.grid->SetDimensions(static_cast<int>(field.columns()), static_cast<int>(field.rows()), 1);
  p.grid->SetSpacing(field.dx(), field.dy(), 1);
  p.fraction->SetNumberOfValues(count);
  std::copy(field.fraction().begin(), field.fraction().end(), p.fraction->GetPointer(0));
  p.fraction->Modified();
  p.grid->Modified();
  p.contour->Update();
  p.actor->SetVisibility(p.contour->GetOutput()->GetNumberOfPoints() > 0);
  set_pose(p.actor, pose, p.layer);
}

}  // namespace seiche::render
