#include "render/files/read_vtu.hpp"

#include <fmt/format.h>
#include <vtkCommand.h>
#include <vtkDataCompressor.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <charconv>
#include <new>
#include <stdexcept>

#include "solver/quantity.hpp"

namespace seiche::render {
namespace {

// Notes that something went wrong, which VTK would print and go on.
class ErrorObserver : public vtkCommand {
 public:
  static ErrorObserver* New() { return new ErrorObserver; }
  void Execute(vtkObject*, unsigned long, void*) override { met = true; }
  bool met = false;
};

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

void watch(vtkObject* object, ErrorObserver* observer) {
  if (!object) return;
  object->AddObserver(vtkCommand::ErrorEvent, observer);
  object->AddObserver(vtkCommand::WarningEvent, observer);
}

// Null where VTK can't read the file.
Grid read_grid(const std::filesystem::path& file) try {
  vtkNew<ErrorObserver> observer;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  watch(reader, observer);
  watch(reader->GetExecutive(), observer);
  reader->SetReaderErrorObserver(observer);
  reader->SetParserErrorObserver(observer);
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  if (observer->met) return {};
  // The decompressor has a voice of its own, and is there only now.
  if (vtkXMLDataParser* parser = reader->GetXMLParser()) watch(parser->GetCompressor(), observer);
  reader->Update();
  return observer->met ? Grid{} : Grid(reader->GetOutput());
} catch (const std::bad_alloc&) {  // a size that is damaged
  return {};
}

// What makes a VTU file ours: its arrays, by name, type and size.
class Arrays {
 public:
  Arrays(vtkFieldData* data, std::string where) : data_(data), where_(std::move(where)) {}

  template <class Array>
  Array* get(const char* name, vtkIdType rows, int columns) const {
    auto* array = Array::SafeDownCast(data_->GetAbstractArray(name));
    if (!array || array->GetNumberOfTuples() != rows || array->GetNumberOfComponents() != columns)
      throw std::runtime_error(fmt::format("{} has no {} as Seiche writes it", where_, name));
    return array;
  }

  bool has(const char* name) const { return data_->GetAbstractArray(name) != nullptr; }

  /// One number for each particle, or `columns` of them.
  template <class Array, class Value>
  void copy(const char* name, std::vector<Value>& out, std::size_t rows, int columns = 1) const {
    const auto* from =
        reinterpret_cast<const Value*>(get<Array>(name, static_cast<vtkIdType>(rows), columns)->GetPointer(0));
    out.assign(from, from + rows);
  }

 private:
  vtkFieldData* data_;
  std::string where_;
};

double number(const Arrays& fields, const char* name) { return fields.get<vtkDoubleArray>(name, 1, 1)->GetValue(0); }

template <int N>
Eigen::Vector<double, N> numbers(const Arrays& fields, const char* name) {
  return Eigen::Map<const Eigen::Vector<double, N>>(fields.get<vtkDoubleArray>(name, N, 1)->GetPointer(0));
}

RigidState pose_of(const Arrays& fields) {
  RigidState pose;
  pose.displacement = numbers<3>(fields, "tank_displacement");
  pose.velocity = numbers<3>(fields, "tank_velocity");
  pose.acceleration = numbers<3>(fields, "tank_acceleration");
  const Eigen::Vector4d q = numbers<4>(fields, "tank_orientation");
  pose.orientation = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  pose.omega = numbers<3>(fields, "tank_angular_velocity");
  pose.alpha = numbers<3>(fields, "tank_angular_acceleration");
  pose.pivot = numbers<3>(fields, "tank_pivot");
  return pose;
}

long step_of(const Arrays& fields) {
  const std::string text = fields.get<vtkStringArray>("step", 1, 1)->GetValue(0);
  long step = 0;
  std::from_chars(text.data(), text.data() + text.size(), step);
  return step;
}

}  // namespace

Frame read_vtu(const std::filesystem::path& file, long index) {
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error(fmt::format("{} isn't there", file.string()));
  const Grid grid = read_grid(file);
  if (!grid) throw std::runtime_error(fmt::format("{} can't be read: it is damaged or no VTU file", file.string()));

  const Arrays fields(grid->GetFieldData(), file.string()), points(grid->GetPointData(), file.string());
  Frame frame;
  frame.index = index;
  frame.step = step_of(fields);
  frame.time = number(fields, "TimeValue");
  frame.pose = pose_of(fields);
  const auto n = static_cast<std::size_t>(grid->GetNumberOfPoints());
  if (n > 0) {
    auto* positions = vtkFloatArray::SafeDownCast(grid->GetPoints()->GetData());
    if (!positions) throw std::runtime_error(fmt::format("{} has no positions as Seiche writes them", file.string()));
    frame.position.resize(n);
    std::copy_n(positions->GetPointer(0), 3 * n, frame.position[0].data());
  }
  points.copy<vtkFloatArray>("velocity", frame.velocity, n, 3);
  points.copy<vtkFloatArray>("pressure", frame.pressure, n);
  points.copy<vtkFloatArray>("number_density", frame.number_density, n);
  points.copy<vtkUnsignedCharArray>("kind", frame.kind, n);
  points.copy<vtkUnsignedCharArray>("free_surface", frame.free_surface, n);
  points.copy<vtkUnsignedIntArray>("id", frame.id, n);
  for (const QuantityRow& row : ChoiceTable<Quantity>::rows) {
    const std::string name(row.name);
    if (row.of || !points.has(name.c_str())) continue;
    frame.derived.push_back({row.value, {}});
    points.copy<vtkFloatArray>(name.c_str(), frame.derived.back().values, n);
  }
  return frame;
}

}  // namespace seiche::render
