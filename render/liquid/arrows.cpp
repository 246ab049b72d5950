#include "render/liquid/arrows.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/liquid/arrow.hpp"
#include "render/liquid/particles.hpp"
#include "render/picture/pose.hpp"

namespace seiche::render {
namespace {

constexpr double shortest = 0.3;  // [font heights]; what is below would be a speck

}  // namespace

std::vector<std::size_t> arrow_bearers(const Frame& frame, double apart) {
  struct Nearest {
    std::size_t particle;
    double distance;
  };
  std::map<std::pair<long, long>, Nearest> squares;  // ordered, so that pictures are the same each time
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.kind[i] != Kind::fluid) continue;
    const double x = frame.position[i][0] / apart, y = frame.position[i][1] / apart;
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const double column = std::floor(x), row = std::floor(y);
    const double distance = std::hypot(x - column - 0.5, y - row - 0.5);
    if (distance > 0.5) continue;
    const auto [at, first] = squares.try_emplace({std::lround(column), std::lround(row)}, Nearest{i, distance});
    if (!first && distance < at->second.distance) at->second = {i, distance};
  }
  std::vector<std::size_t> bearers;
  for (const auto& [square, nearest] : squares) bearers.push_back(nearest.particle);
  return bearers;
}

/// Polygons of one colour.
struct Arrows::Shapes {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkActor> actor;

  Shapes(vtkRenderer* renderer, Rgb colour) {
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    shape->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
  }

  void clear() {
    points->Reset();
    cells->Reset();
  }
  void add(const Line& corners) {
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const auto& [x, y] : corners) cells->InsertCellPoint(points->InsertNextPoint(x, y, 0));
  }
  void finish(const RigidState& pose, double height) {
    points->Modified();
    cells->Modified();
    actor->SetVisibility(cells->GetNumberOfCells() > 0);
    set_pose(actor, pose, height);
  }
};

Arrows::Arrows(vtkRenderer* renderer, const RunInfo& run, const ArrowScale& lengths, double scale, double font)
    : lengths_(lengths),
      font_(font / scale),
      apart_(std::max(arrow_distance * font_, 1.5 * run.spacing)),
      layer_(Particles::layer_height(run)),
      halos_(std::make_unique<Shapes>(renderer, halo)),
      shafts_(std::make_unique<Shapes>(renderer, foreground)) {}

Arrows::~Arrows() = default;

void Arrows::show(const Frame& frame, const RigidState& pose) {
  halos_->clear();
  shafts_->clear();
  for (const std::size_t i : arrow_bearers(frame, apart_)) {
    const double u = frame.velocity[i][0], v = frame.velocity[i][1], speed = std::hypot(u, v);
    const double length = lengths_.length * std::min(speed, lengths_.greatest);
    if (!(length >= shortest) || !std::isfinite(speed)) continue;
    const Point middle{frame.position[i][0], frame.position[i][1]};
    const ArrowShape arrow = placed(arrow_shape(length * font_, font_), middle, {u / speed, v / speed});
    halos_->add(arrow.shaft_halo);
    halos_->add(arrow.head_halo);
    shafts_->add(arrow.shaft);
    shafts_->add(arrow.head);
  }
  // Over the marks of the free surface; no arrow's halo cuts another.
  halos_->finish(pose, 2 * layer_);
  shafts_->finish(pose, 2.5 * layer_);
}

}  // namespace seiche::render
