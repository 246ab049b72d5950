#include "render/picture/tank.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>

namespace seiche::render {
namespace {

void add_bar(vtkPoints* points, vtkCellArray* cells, double x0, double y0, double x1, double y1) {
  cells->InsertNextCell(4);
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    cells->InsertCellPoint(points->InsertNextPoint(x, y, 0));
}

// Bars outside of the inner walls, so that the liquid reaches exactly to the line.
void outline_2d(const RunInfo& run, double line, vtkPolyData* shape) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const double length = run.tank[0], height = run.tank[1], top = run.closed ? height + line : height;
  add_bar(points, cells, -line, -line, length + line, 0);
  add_bar(points, cells, -line, 0, 0, top);
  add_bar(points, cells, length, 0, length + line, top);
  if (run.closed) add_bar(points, cells, 0, height, length, height + line);
  shape->SetPoints(points);
  shape->SetPolys(cells);
}

// The edges of the box; those of an open top are edges all the same.
void edges_3d(const RunInfo& run, vtkPolyData* shape) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int corner = 0; corner < 8; ++corner)
    points->InsertNextPoint(corner & 1 ? run.tank[0] : 0, corner & 2 ? run.tank[1] : 0, corner & 4 ? run.tank[2] : 0);
  for (int corner = 0; corner < 8; ++corner)
    for (const int bit : {1, 2, 4})
      if (!(corner & bit)) {
        const vtkIdType edge[] = {corner, corner | bit};
        cells->InsertNextCell(2, edge);
      }
  shape->SetPoints(points);
  shape->SetLines(cells);
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
    outline_2d(run, line, shape);
    mapper->SetInputData(shape);
  } else {
    edges_3d(run, shape);
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
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto [length, height, width] = run.tank;
  const double faces[][4][3] = {{{0, 0, 0}, {length, 0, 0}, {length, 0, width}, {0, 0, width}},
                                {{0, 0, 0}, {0, height, 0}, {0, height, width}, {0, 0, width}},
                                {{0, 0, 0}, {length, 0, 0}, {length, height, 0}, {0, height, 0}}};
  for (const auto& face : faces) {
    cells->InsertNextCell(4);
    for (const auto& corner : face) cells->InsertCellPoint(points->InsertNextPoint(corner));
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_colour(actor, colour);
  return actor;
}

}  // namespace seiche::render
