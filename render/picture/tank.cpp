#include "render/picture/tank.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>

#include <Eigen/Core>
#include <algorithm>

#include "render/picture/camera.hpp"
#include "render/picture/tank_edges.hpp"

namespace seiche::render {
namespace {

Eigen::Vector2d outward(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = (to - from).normalized();
  return {along[1], -along[0]};
}

// Bars outside of the wall's surface, so that the liquid reaches exactly to the line; mitred where two meet.
void outline_2d(const SurfaceMesh& tank, double line, vtkPolyData* shape) {
  const auto at = [&](int k) { return Eigen::Vector2d(tank.points[k].data()); };
  std::vector<Eigen::Vector2d> first(tank.points.size(), Eigen::Vector2d::Zero()), offset = first;
  for (const SurfaceMesh::Patch& patch : tank.patches)
    for (const auto& face : patch.faces)
      for (const int k : face) {
        const Eigen::Vector2d normal = outward(at(face[0]), at(face[1]));
        // Of two normals the mitre is (m + n)/(1 + m.n); it is cut where they are nearly opposite.
        offset[k] = first[k].isZero() ? normal : (first[k] + normal) / std::max(0.25, 1 + first[k].dot(normal));
        first[k] = normal;
      }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto corner = [&](const Eigen::Vector2d& r) { return points->InsertNextPoint(r[0], r[1], 0); };
  for (const SurfaceMesh::Patch& patch : tank.patches)
    for (const auto& face : patch.faces) {
      const int from = face[0], to = face[1];
      const vtkIdType bar[] = {corner(at(from)), corner(at(to)), corner(at(to) + line * offset[to]),
                               corner(at(from) + line * offset[from])};
      cells->InsertNextCell(4, bar);
    }
  shape->SetPoints(points);
  shape->SetPolys(cells);
}

void edges_3d(const SurfaceMesh& tank, vtkPolyData* shape) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : tank_edges(tank, Eigen::Vector3d(towards_camera.data()))) {
    lines->InsertNextCell(2);
    for (const Eigen::Vector3d& end : edge) lines->InsertCellPoint(points->InsertNextPoint(end.data()));
  }
  shape->SetPoints(points);
  shape->SetLines(lines);
}

void faces_3d(const SurfaceMesh& tank, vtkPolyData* shape) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& point : tank.points) points->InsertNextPoint(point.data());
  for (const SurfaceMesh::Patch& patch : tank.patches)
    for (const auto& face : patch.faces) {
      cells->InsertNextCell(static_cast<int>(face.size()));
      for (const int corner : face) cells->InsertCellPoint(corner);
    }
  shape->SetPoints(points);
  shape->SetPolys(cells);
}

void set_colour(vtkActor* actor, Rgb colour) {
  actor->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  actor->GetProperty()->LightingOff();
}

}  // namespace

vtkSmartPointer<vtkActor> tank_outline(const RunInfo& run, double line, Rgb colour) {
  vtkNew<vtkPolyData> shape;
  vtkNew<vtkPolyDataMapper> mapper;
  if (run.dimension == 2) {
    outline_2d(run.tank, line, shape);
    mapper->SetInputData(shape);
  } else {
    edges_3d(run.tank, shape);
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(shape);
    tubes->SetRadius(line / 2);
    tubes->SetNumberOfSides(12);
    tubes->CappingOn();
    mapper->SetInputConnection(tubes->GetOutputPort());
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_colour(actor, colour);
  return actor;
}

vtkSmartPointer<vtkActor> tank_back(const RunInfo& run, Rgb colour) {
  vtkNew<vtkPolyData> shape;
  faces_3d(run.tank, shape);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_colour(actor, colour);
  actor->GetProperty()->FrontfaceCullingOn();
  return actor;
}

}  // namespace seiche::render
