#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "render/outputs.hpp"
#include "tests/unit/render/scratch.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

const test::Box box{.length = 0.1, .height = 0.1, .depth = 0.05, .spacing = 0.01};

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

vtkSmartPointer<vtkUnstructuredGrid> read(const std::filesystem::path& file) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

struct Listed {
  double time;
  std::string file;
};

std::vector<Listed> listed_in_pvd(const std::filesystem::path& file) {
  std::vector<Listed> all;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  if (!root) return all;
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* collection = root->GetNestedElement(0);
  EXPECT_STREQ(collection->GetName(), "Collection");
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* entry = collection->GetNestedElement(i);
    all.push_back({std::stod(entry->GetAttribute("timestep")), entry->GetAttribute("file")});
  }
  return all;
}

std::vector<Listed> listed_in_series(const std::filesystem::path& file) {
  std::vector<Listed> all;
  const auto series = nlohmann::json::parse(bytes_of(file));
  for (const auto& entry : series.at("files")) all.push_back({entry.at("time"), entry.at("name")});
  return all;
}

}  // namespace

TEST(Vtu, VtkReadsBackEveryArray) {
  const test::Scratch scratch;
  const auto sink = vtu_series(scratch.folder());
  const auto frame = test::lattice(box, 0.1, 7);
  sink->begin(test::run_info(box));
  sink->frame(frame);
  sink->end();

  const auto grid = read(scratch / "vtu/pan2008_000007.vtu");
  const auto count = static_cast<vtkIdType>(frame->size());
  ASSERT_EQ(grid->GetNumberOfPoints(), count);
  ASSERT_EQ(grid->GetNumberOfCells(), count);
  vtkPointData* data = grid->GetPointData();
  for (const char* name : {"velocity", "pressure", "number_density", "kind", "free_surface", "id"})
    ASSERT_TRUE(data->GetArray(name)) << name;
  EXPECT_EQ(data->GetArray("velocity")->GetNumberOfComponents(), 3);
  for (vtkIdType i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(grid->GetCellType(i), VTK_VERTEX);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(static_cast<float>(grid->GetPoint(i)[axis]), frame->position[k][static_cast<std::size_t>(axis)]);
      EXPECT_EQ(data->GetArray("velocity")->GetComponent(i, axis), frame->velocity[k][static_cast<std::size_t>(axis)]);
    }
    EXPECT_EQ(data->GetArray("pressure")->GetComponent(i, 0), frame->pressure[k]);
    EXPECT_EQ(data->GetArray("number_density")->GetComponent(i, 0), frame->number_density[k]);
    EXPECT_EQ(data->GetArray("kind")->GetComponent(i, 0), static_cast<int>(frame->kind[k]));
    EXPECT_EQ(data->GetArray("free_surface")->GetComponent(i, 0), frame->free_surface[k]);
    EXPECT_EQ(data->GetArray("id")->GetComponent(i, 0), frame->id[k]);
  }
  vtkFieldData* fields = grid->GetFieldData();
  EXPECT_DOUBLE_EQ(fields->GetArray("TimeValue")->GetComponent(0, 0), frame->time);
  EXPECT_DOUBLE_EQ(fields->GetArray("tank_displacement")->GetComponent(0, 0), frame->pose.displacement[0]);
  EXPECT_EQ(fields->GetArray("tank_orientation")->GetComponent(0, 0), frame->pose.orientation.w());
  EXPECT_EQ(fields->GetArray("tank_pivot")->GetComponent(0, 1), frame->pose.pivot[1]);
  const auto text = [&](const char* name) {
    return vtkStringArray::SafeDownCast(fields->GetAbstractArray(name))->GetValue(0);
  };
  EXPECT_EQ(text("software"), "Seiche 0.1.0");
  EXPECT_EQ(text("scene_hash"), "0123456789abcdef");
  EXPECT_EQ(text("parameters"), "preset = \"stabilised\"\n");
}

TEST(Vtu, IsWellFormedWithLz4AndLongHeaders) {
  const test::Scratch scratch;
  const auto sink = vtu_series(scratch.folder());
  sink->begin(test::run_info(box));
  sink->frame(test::lattice(box, 0));
  const std::string bytes = bytes_of(scratch / "vtu/pan2008_000000.vtu");
  for (const char* part : {"vtkLZ4DataCompressor", "header_type=\"UInt64\"", "format=\"binary\""})
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
  EXPECT_EQ(bytes.find("AppendedData"), std::string::npos) << "which not every ParaView can read";
  EXPECT_TRUE(std::ranges::all_of(bytes, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); })) << "text";
}

TEST(Vtu, ListsAreWholeAfterEveryFrame) {
  const test::Scratch scratch;
  auto run = test::run_info(box);
  run.name = "a & \"b\"";
  const auto sink = vtu_series(scratch.folder());
  sink->begin(run);
  for (long index = 0; index < 3; ++index) {
    sink->frame(test::lattice(box, 0, index));
    for (const auto& all :
         {listed_in_pvd(scratch / "a & \"b\".pvd"), listed_in_series(scratch / "a & \"b\".vtu.series")}) {
      ASSERT_EQ(all.size(), static_cast<std::size_t>(index) + 1);
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(all[i].time, 0.02 * static_cast<double>(i), 1e-12);
        const auto grid = read(scratch / all[i].file);
        EXPECT_GT(grid->GetNumberOfPoints(), 0) << all[i].file;
        EXPECT_NEAR(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), all[i].time, 1e-12);
      }
    }
  }
}

TEST(Vtu, SameFrameSameBytes) {
  const test::Scratch scratch;
  for (const char* folder : {"a", "b"}) {
    const auto sink = vtu_series(scratch / folder);
    sink->begin(test::run_info(box));
    sink->frame(test::lattice(box, 0.1, 5));
  }
  const std::string first = bytes_of(scratch / "a/vtu/pan2008_000005.vtu");
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, bytes_of(scratch / "b/vtu/pan2008_000005.vtu"));
}

TEST(Vtu, TakesAFrameWithoutParticles) {
  const test::Scratch scratch;
  const auto sink = vtu_series(scratch.folder());
  sink->begin(test::run_info(box));
  sink->frame(std::make_shared<Frame>());
  EXPECT_EQ(read(scratch / "vtu/pan2008_000000.vtu")->GetNumberOfPoints(), 0);
  EXPECT_EQ(listed_in_pvd(scratch / "pan2008.pvd").size(), 1u);
}
