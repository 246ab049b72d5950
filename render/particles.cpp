#include "render/particles.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace seiche::render {

/// One actor with the particles of one sort. Its arrays are filled anew for each frame.
struct Particles::Layer {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkPolyData> cloud;
  vtkNew<vtkActor> actor;

  Layer(vtkRenderer* renderer, vtkPolyDataMapper* mapper) {
    points->SetDataTypeToFloat();
    colours->SetNumberOfComponents(3);
    cloud->SetPoints(points);
    cloud->SetVerts(verts);
    cloud->GetPointData()->SetScalars(colours);
    mapper->SetInputData(cloud);
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }

  void clear() {
    points->Reset();
    colours->Reset();
  }
  void add(const Float3& at, Rgb colour) {
    points->InsertNextPoint(at.data());
    colours->InsertNextTypedTuple(colour.data());
  }
  void finish() {
    // One cell of all points: the mappers look at points alone, and this takes no time to make.
    const vtkIdType count = points->GetNumberOfPoints();
    if (verts->GetNumberOfConnectivityIds() != count) {
      verts->Reset();
      verts->InsertNextCell(static_cast<int>(count));
      for (vtkIdType i = 0; i < count; ++i) verts->InsertCellPoint(i);
      verts->Modified();
    }
    points->Modified();
    colours->Modified();
    cloud->Modified();
    actor->SetVisibility(count > 0);
  }
};

namespace {

// Discs with a darker rim, or rings, with `hole` and `rim` as parts of the radius and `soft` the width of its smooth edge.
vtkSmartPointer<vtkPointGaussianMapper> disc_mapper(double radius, double hole, double rim, double soft) {
  auto mapper = vtkSmartPointer<vtkPointGaussianMapper>::New();
  mapper->SetScaleFactor(radius);
  mapper->SetTriangleScale(1);
  mapper->EmissiveOff();
  const std::string shader = fmt::format(
      "//VTK::Color::Impl\n"
      "float r = length(offsetVCVSOutput.xy);\n"
      "if (r > 1.0 || r < {:.4f}) discard;\n"
      "float dark = mix(1.0, 0.72, smoothstep({:.4f}, {:.4f}, r));\n"
      "ambientColor *= dark; diffuseColor *= dark;\n",
      hole, 1 - rim - soft, 1 - rim + 1e-3);
  mapper->SetSplatShaderCode(shader.c_str());
  return mapper;
}

}  // namespace

Particles::Particles(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double smallest)
    : map_(look.colour_map) {
  const bool dots = look.style == "dot";
  const double radius = (dots ? 0.28 : 0.5) * run.spacing;
  if (run.dimension == 3) {
    const auto spheres = [&](double size) {
      vtkNew<vtkOpenGLSphereMapper> mapper;
      mapper->SetRadius(static_cast<float>(size));
      auto layer = std::make_unique<Layer>(renderer, mapper);
      layer->actor->GetProperty()->SetAmbient(0.25);
      layer->actor->GetProperty()->SetDiffuse(0.8);
      layer->actor->GetProperty()->SetSpecular(0.12);
      layer->actor->GetProperty()->SetSpecularPower(20);
      return layer;
    };
    fluid_ = spheres(radius);
    return;
  }
  const auto discs = [&](double size, double hole, double rim, double z) {
    const double pixel = 1 / (size * scale);
    auto layer = std::make_unique<Layer>(renderer, disc_mapper(size, hole, rim, 2 * pixel));
    layer->actor->GetProperty()->LightingOff();
    layer->actor->SetPosition(0, 0, z * run.spacing);
    return layer;
  };
  // A rim is drawn where a disc is large enough that it doesn't darken the whole of it.
  const double pixels = radius * scale;
  const double rim = dots ? 0 : std::clamp((pixels - 4) / 40, 0.0, 0.12);
  const double filled = std::max(radius, 0.75 / scale);
  if (look.show_walls) {
    dummy_ = discs(filled, 0, 0, -2);
    wall_ = discs(filled, 0, 0, -1);
  }
  fluid_ = discs(filled, 0, rim, 0);
  if (look.show_surface) {
    const double size = std::max(1.08 * radius, smallest / scale);
    const double stroke = std::clamp(smallest / (size * scale), 0.3, 1.0);
    surface_ = discs(size, 1 - stroke, 0, 1);
  }
}

Particles::~Particles() = default;

void Particles::show(const Frame& frame, Range range, const Double3& shift) {
  Layer* const layers[] = {fluid_.get(), surface_.get(), wall_.get(), dummy_.get()};
  for (Layer* layer : layers)
    if (layer) layer->clear();
  const double width = range.high - range.low;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    Float3 at = frame.position[i];
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += static_cast<float>(shift[axis]);
    switch (frame.kind[i]) {
      case Kind::fluid:
        fluid_->add(at, map_((frame.pressure[i] - range.low) / width));
        if (surface_ && frame.free_surface[i]) surface_->add(at, surface_colour);
        break;
      case Kind::wall:
        if (wall_) wall_->add(at, wall_colour);
        break;
      case Kind::dummy:
        if (dummy_) dummy_->add(at, dummy_colour);
        break;
    }
  }
  for (Layer* layer : layers)
    if (layer) layer->finish();
}

}  // namespace seiche::render
