#include "render/files/vtu.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>

#include "render/files/file.hpp"
#include "solver/quantity.hpp"

namespace seiche::render {
namespace {

// VTK's array over the frame's own memory, which outlives it.
template <typename Array, typename Value>
vtkSmartPointer<Array> view(const char* name, const Value* data, std::size_t rows, int columns) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(columns);
  constexpr int keep = 1;
  array->SetArray(const_cast<Value*>(data), static_cast<vtkIdType>(rows) * columns, keep);
  return array;
}

// One VTK_VERTEX for each point.
vtkSmartPointer<vtkCellArray> vertices(std::size_t count) {
  vtkNew<vtkTypeInt64Array> offsets, points;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(count) + 1);
  points->SetNumberOfValues(static_cast<vtkIdType>(count));
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + count + 1, 0);
  std::iota(points->GetPointer(0), points->GetPointer(0) + count, 0);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

void add_particles(const Frame& frame, vtkUnstructuredGrid* grid) {
  const std::size_t n = frame.size();
  vtkNew<vtkPoints> points;
  points->SetData(view<vtkFloatArray>("position", n ? frame.position[0].data() : nullptr, n, 3));
  grid->SetPoints(points);
  grid->SetCells(VTK_VERTEX, vertices(n));
  vtkPointData* data = grid->GetPointData();
  data->AddArray(view<vtkFloatArray>("velocity", n ? frame.velocity[0].data() : nullptr, n, 3));
  data->AddArray(view<vtkFloatArray>("pressure", frame.pressure.data(), n, 1));
  data->AddArray(view<vtkFloatArray>("number_density", frame.number_density.data(), n, 1));
  data->AddArray(view<vtkUnsignedCharArray>("kind", reinterpret_cast<const unsigned char*>(frame.kind.data()), n, 1));
  data->AddArray(view<vtkUnsignedCharArray>("free_surface", frame.free_surface.data(), n, 1));
  data->AddArray(view<vtkUnsignedIntArray>("id", frame.id.data(), n, 1));
  for (const DerivedField& field : frame.derived)
    data->AddArray(view<vtkFloatArray>(std::string(name(field.quantity)).c_str(), field.values.data(), n, 1));
  data->SetActiveScalars("pressure");
}

void add_field(vtkFieldData* fields, const std::string& name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(text);
  fields->AddArray(array);
}

void add_field(vtkFieldData* fields, const char* name, const double* values, std::size_t count) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (std::size_t i = 0; i < count; ++i) array->InsertNextValue(values[i]);
  fields->AddArray(array);
}

}  // namespace

void write_vtu(const std::filesystem::path& file, const Frame& frame, const Notes& notes) {
  vtkNew<vtkUnstructuredGrid> grid;
  add_particles(frame, grid);
  vtkFieldData* fields = grid->GetFieldData();
  add_field(fields, "TimeValue", &frame.time, 1);
  add_field(fields, "tank_displacement", frame.pose.displacement.data(), 3);
  add_field(fields, "tank_velocity", frame.pose.velocity.data(), 3);
  add_field(fields, "tank_acceleration", frame.pose.acceleration.data(), 3);
  const Eigen::Quaterniond& q = frame.pose.orientation;
  add_field(fields, "tank_orientation", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()).data(), 4);
  add_field(fields, "tank_angular_velocity", frame.pose.omega.data(), 3);
  add_field(fields, "tank_angular_acceleration", frame.pose.alpha.data(), 3);
  add_field(fields, "tank_pivot", frame.pose.pivot.data(), 3);
  for (const auto& [keyword, text] : notes) {
    std::string name = keyword;
    for (char& c : name) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    add_field(fields, name, text);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(partial_name(file).c_str());
  // A third larger than raw data appended, but well-formed: Debian 12's ParaView can read nothing else since its
  // libexpat came to put off parsing.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToLZ4();
  writer->SetHeaderTypeToUInt64();
  if (!writer->Write()) throw std::runtime_error(fmt::format("can't write {}: is the disk full?", file.string()));
  publish(file);
}

}  // namespace seiche::render
