#include "render/liquid/particles.hpp"

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
#include <cmath>

#include "render/liquid/surface_mark.hpp"

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

struct Disc {
  double radius = 0;     // [m]
  double hole = 0;       // of a ring, as part of the radius
  double edge = 1;       // where the darker edge begins, as part of the radius
  double shade = 0;      // how much darker it is
  double relief = 1e-3;  // height of the cone, in depths of the picture
  double layer = 0;      // discs of a greater layer cover those of a smaller one
};

// Each disc is drawn as a flat cone: where two of one layer overlap they meet half-way, whichever is drawn first.
vtkSmartPointer<vtkPointGaussianMapper> disc_mapper(const Disc& disc) {
  auto mapper = vtkSmartPointer<vtkPointGaussianMapper>::New();
  mapper->SetScaleFactor(disc.radius);
  mapper->SetTriangleScale(1.0f);
  mapper->EmissiveOff();
  const std::string shader = fmt::format(
      "//VTK::Color::Impl\n"
      "vec2 at = abs(offsetVCVSOutput.xy);\n"
      "float r = length(at);\n"
      "if (r > 1.0 || r < {:.4f}) discard;\n"
      "gl_FragDepth = gl_FragCoord.z + {:.6f} * r;\n"
      "float shade = 1.0 - {:.4f} * smoothstep({:.4f}, {:.4f}, r);\n"
      "ambientColor *= shade; diffuseColor *= shade;\n",
      disc.hole, disc.relief, disc.shade, disc.edge, 0.5 * (1 + disc.edge));
  mapper->SetSplatShaderCode(shader.c_str());
  return mapper;
}

}  // namespace

Particles::Particles(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke,
                     double finest)
    : quantity_(look.quantity), map_(look.colour_map) {
  if (run.dimension == 3)
    make_spheres(renderer, run, look, scale, stroke);
  else
    make_discs(renderer, run, look, scale, stroke, finest);
}

void Particles::make_spheres(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke) {
  const double radius = run.spacing * (look.style == Style::dot ? 0.28 : 0.5);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetRadius(static_cast<float>(radius));
  fluid_ = std::make_unique<Layer>(renderer, mapper);
  vtkProperty* property = fluid_->actor->GetProperty();
  property->SetAmbient(0.35);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.1);
  property->SetSpecularPower(20);
  if (surface_mark(look) == SurfaceMark::rings) {
    // A small ring on each sphere, towards the camera.
    const double size = std::max(0.5 * radius, stroke / scale);
    surface_ = std::make_unique<Layer>(renderer, disc_mapper({.radius = size, .hole = 0.5, .relief = 0}));
    surface_->actor->GetProperty()->LightingOff();
    const double step = 1.1 * radius / std::sqrt(3.0);
    surface_->actor->SetPosition(step, step, step);
  }
}

void Particles::make_discs(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke,
                           double finest) {
  const bool dots = look.style == Style::dot;
  const auto discs = [&](const Disc& disc) {
    auto layer = std::make_unique<Layer>(renderer, disc_mapper(disc));
    layer->actor->GetProperty()->LightingOff();
    layer->actor->SetPosition(0, 0, disc.layer * layer_height(run));
    return layer;
  };
  // Large discs stand apart; small ones close up, since the gaps of a lattice make moire. All are rimmed but the
  // smallest, so that each particle can be seen.
  const double pixels = run.spacing * scale;
  const double closed = dots ? 0 : std::clamp((16 - finest * scale) / 6, 0.0, 1.0);
  const double shade = dots ? 0 : 0.28 * std::clamp((pixels - 2) / 4, 0.0, 1.0);
  const double half = run.spacing * (dots ? 0.28 : 0.5);
  const double radius = half * (1 + 0.5 * closed);
  if (look.show_walls && closed > 0) {
    squares_ = std::make_unique<WallSquares>(renderer, run, layer_height(run), wall(Kind::wall), wall(Kind::dummy));
  } else if (look.show_walls) {
    dummy_ = discs({.radius = half, .layer = -2});
    wall_ = discs({.radius = half, .layer = -1});
  }
  fluid_ = discs({.radius = radius, .edge = 0.8 / (1 + 0.5 * closed), .shade = shade});
  if (surface_mark(look) == SurfaceMark::rings) {
    const double size = std::max(0.5 * run.spacing, 1.4 * stroke / scale);
    surface_ = discs({.radius = size, .hole = 1 - stroke / (size * scale), .layer = 1});
    // Those marked keep their true size, so that their mark goes round them and no spray looks larger than it is.
    if (closed > 0) marked_ = discs({.radius = half, .edge = 0.8, .shade = shade});
  }
}

double Particles::layer_height(const RunInfo& run) { return 0.02 * (run.tank.size()[0] + run.tank.size()[1]); }

Particles::~Particles() = default;

Rgb Particles::wall(Kind kind) const {
  if (quantity_ == Quantity::kind) return classes_of(quantity_)[static_cast<std::size_t>(kind)].colour;
  return kind == Kind::wall ? wall_colour : dummy_colour;
}

void Particles::show(const Frame& frame, Range range, const RigidState& pose, const SmoothField* area) {
  Layer* const layers[] = {fluid_.get(), marked_.get(), surface_.get(), wall_.get(), dummy_.get()};
  for (Layer* layer : layers)
    if (layer) layer->clear();
  const double width = range.high - range.low;
  const auto& classes = classes_of(quantity_);
  const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
  const Eigen::Vector3d origin = pose.pivot + pose.displacement - rotation * pose.pivot;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Float3& in_tank = frame.position[i];
    const Eigen::Vector3d lab = origin + rotation * Eigen::Vector3d(in_tank[0], in_tank[1], in_tank[2]);
    const Float3 at{static_cast<float>(lab[0]), static_cast<float>(lab[1]), static_cast<float>(lab[2])};
    switch (frame.kind[i]) {
      case Kind::fluid: {
        if (area && area->fraction_at(in_tank[0], in_tank[1]) > SmoothField::surface) break;
        const bool marked = surface_ && frame.free_surface[i];
        const double value = value_of(quantity_, frame, i);
        const Rgb colour =
            classes.empty() ? map_((value - range.low) / width) : classes[static_cast<std::size_t>(value)].colour;
        (marked && marked_ ? marked_ : fluid_)->add(at, colour);
        if (marked) surface_->add(at, surface_colour);
        break;
      }
      case Kind::wall:
        if (wall_) wall_->add(at, wall(Kind::wall));
        break;
      case Kind::dummy:
        if (dummy_) dummy_->add(at, wall(Kind::dummy));
        break;
    }
  }
  for (Layer* layer : layers)
    if (layer) layer->finish();
  if (squares_) squares_->show(frame, pose);
}

}  // namespace seiche::render
