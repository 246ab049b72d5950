#include "render/liquid/smooth_liquid.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render/picture/pose.hpp"
#include "render/picture/tank_section.hpp"

namespace seiche::render {

struct SmoothLiquid::Parts {
  vtkNew<vtkImageData> grid;
  vtkNew<vtkUnsignedCharArray> texels;  // colour, and the volume fraction as alpha
  vtkNew<vtkTexture> texture;
  vtkNew<vtkActor> actor;
};

SmoothLiquid::SmoothLiquid(vtkRenderer* renderer, const RunInfo& run, const SmoothField& field, const ColourMap& map)
    : map_(map), parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  const auto columns = static_cast<double>(field.columns()), rows = static_cast<double>(field.rows());
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> texture_coordinates;
  vtkNew<vtkCellArray> cells;
  texture_coordinates->SetNumberOfComponents(2);
  for (const auto& corners : TankSection(run).quadrilaterals(field.bottom() + field.dy() * (rows - 1))) {
    cells->InsertNextCell(4);
    for (const Eigen::Vector2d& r : corners) {
      cells->InsertCellPoint(points->InsertNextPoint(r[0], r[1], 0));
      // A texel's colour is at its middle.
      texture_coordinates->InsertNextTuple2((0.5 + (r[0] - field.left()) / field.dx()) / columns,
                                            (0.5 + (r[1] - field.bottom()) / field.dy()) / rows);
    }
  }
  vtkNew<vtkPolyData> sheet;
  sheet->SetPoints(points);
  sheet->SetPolys(cells);
  sheet->GetPointData()->SetTCoords(texture_coordinates);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(sheet);
  p.actor->SetMapper(mapper);
  p.actor->GetProperty()->LightingOff();

  p.grid->SetDimensions(static_cast<int>(field.columns()), static_cast<int>(field.rows()), 1);
  p.texels->SetNumberOfComponents(4);
  p.texels->SetNumberOfTuples(static_cast<vtkIdType>(field.fraction().size()));
  p.grid->GetPointData()->SetScalars(p.texels);
  p.texture->SetInputData(p.grid);
  p.texture->SetColorModeToDirectScalars();
  p.texture->InterpolateOn();
  p.texture->RepeatOff();
  p.texture->EdgeClampOn();
  p.actor->SetTexture(p.texture);
  p.actor->ForceOpaqueOn();
  p.actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true,
                                                             "//VTK::TCoord::Impl\n"
                                                             "  if (gl_FragData[0].a < 0.5) discard;\n"
                                                             "  gl_FragData[0].a = 1.0;\n",
                                                             false);
  renderer->AddActor(p.actor);
}

SmoothLiquid::~SmoothLiquid() = default;

void SmoothLiquid::show(const SmoothField& field, Range range, const RigidState& pose) {
  Parts& p = *parts_;
  const auto &fraction = field.fraction(), &mean = field.mean();
  std::uint8_t* texel = p.texels->GetPointer(0);
  const double width = range.high - range.low;
  for (std::size_t k = 0; k < fraction.size(); ++k, texel += 4) {
    // 127.5 of 255 is the surface; what is far from the liquid needs no colour.
    texel[3] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(fraction[k] / (2 * SmoothField::surface), 0.0, 1.0)));
    if (texel[3] == 0) continue;
    const Rgb colour = map_((mean[k] - range.low) / width);
    std::copy(colour.begin(), colour.end(), texel);
  }
  p.texels->Modified();
  p.grid->Modified();
  set_pose(p.actor, pose, 0);
}

}  // namespace seiche::render
