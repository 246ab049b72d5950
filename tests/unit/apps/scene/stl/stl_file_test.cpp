#include "apps/scene/stl/stl_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "apps/common/errors.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/scene/stl/stl_bytes.hpp"

namespace seiche::apps {
namespace {

using test::binary_stl;
using test::tetrahedron;
using test::text_stl;

std::string error_of(std::string_view bytes) {
  try {
    parse_stl(bytes, "t.stl", LengthUnit::m);
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

TEST(StlFile, HasTheTrianglesOfEitherKind) {
  for (const std::string& bytes : {binary_stl(tetrahedron()), text_stl(), binary_stl(tetrahedron(), "solid x")}) {
    const StlSurface read = parse_stl(bytes, "", LengthUnit::m);
    EXPECT_EQ(read.degenerate, 0);
    ASSERT_EQ(read.mesh.points.size(), 4U);
    EXPECT_EQ(read.mesh.points[1][1], 2);
    EXPECT_NEAR(read.mesh.high()[2], 0.1, 1e-8);
    std::vector<std::vector<int>> faces;
    for (const auto& patch : read.mesh.patches) faces.insert(faces.end(), patch.faces.begin(), patch.faces.end());
    EXPECT_EQ(faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}));
  }
}

TEST(StlFile, HasAPatchForEachNameOfASolid) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> all;
    for (const auto& patch : parse_stl(text, "", LengthUnit::m).mesh.patches) all.push_back(patch.name);
    return all;
  };
  EXPECT_EQ(names(text_stl()), (std::vector<std::string>{"floor of it", "wall"}));
  EXPECT_EQ(names(binary_stl(tetrahedron(), "solid roof")), (std::vector<std::string>{"wall"}));
  EXPECT_EQ(names(text_stl() + "\n" + text_stl()), (std::vector<std::string>{"floor of it", "wall", "wall-2"}));
  EXPECT_EQ(names("solid empty\nendsolid\nSOLID d\xc3\xb6me\x01\n" + text_stl().substr(20)),
            (std::vector<std::string>{"d??me?", "wall"}));
}

TEST(StlFile, ConvertsItsUnit) {
  for (const auto& [unit, factor] : {std::pair{LengthUnit::m, 1.0},
                                     {LengthUnit::cm, 0.01},
                                     {LengthUnit::mm, 0.001},
                                     {LengthUnit::inch, 0.0254},
                                     {LengthUnit::foot, 0.3048}})
    EXPECT_DOUBLE_EQ(parse_stl(binary_stl(tetrahedron()), "", unit).mesh.high()[1], 2 * factor);
  EXPECT_EQ(value_named<LengthUnit>("in"), LengthUnit::inch);
  EXPECT_EQ(metres(value_named<LengthUnit>("ft")), 0.3048);
}

TEST(StlFile, LeavesOutAndCountsTrianglesThatHaveTwoCornersInOnePlace) {
  auto triangles = tetrahedron();
  triangles.push_back({triangles[0][0], triangles[0][1], triangles[0][0]});
  const StlSurface read = parse_stl(binary_stl(triangles), "", LengthUnit::m);
  EXPECT_EQ(read.degenerate, 1);
  EXPECT_EQ(read.mesh.patches[0].faces.size(), 4U);
  EXPECT_TRUE(
      seiche::test::tells(error_of(binary_stl({triangles[4], triangles[4]})), {"t.stl: no triangle", "2 without"}));
}

TEST(StlFile, CutOffAnywhereIsAnError) {
  const std::string binary = binary_stl(tetrahedron()), text = text_stl();
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_NE(error_of(std::string_view(binary).substr(0, size)), "no error") << size;
  const std::string solid = binary_stl(tetrahedron(), "solid x");
  for (std::size_t size = 0; size < solid.size(); ++size)
    EXPECT_NE(error_of(std::string_view(solid).substr(0, size)), "no error") << size;
  const std::size_t between = text.find("solid\n", 30);  // a whole solid ends there
  for (std::size_t size = 0; size < text.size(); ++size) {
    const bool whole = size >= text.find("endsolid") + 8 && size <= between;
    EXPECT_EQ(error_of(std::string_view(text).substr(0, size)) == "no error", whole) << size;
  }
}

TEST(StlFile, SaysWhereItIsDamaged) {
  EXPECT_TRUE(seiche::test::tells(error_of(""), {"t.stl", "empty"}));
  EXPECT_TRUE(seiche::test::tells(error_of(binary_stl({})), {"t.stl: byte 80", "no triangles"}));
  std::string bytes = binary_stl(tetrahedron());
  EXPECT_TRUE(seiche::test::tells(error_of(bytes.substr(0, 200)),
                                  {"t.stl: byte 200", "triangle 3 of 4", "84 bytes", "export"}));
  EXPECT_TRUE(seiche::test::tells(error_of(bytes + "xy"), {"t.stl: byte 284", "2 bytes more", "4 triangles"}));
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_TRUE(seiche::test::tells(error_of(bytes), {"triangle 5 of 4294967295", "214748364550"}));
  auto triangles = tetrahedron();
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    triangles[2][1][2] = wrong;
    EXPECT_TRUE(seiche::test::tells(error_of(binary_stl(triangles)), {"t.stl: byte 216", "triangle 3 of 4", "finite"}));
  }
  EXPECT_TRUE(seiche::test::tells(error_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1x\n"),
                                  {"t.stl:4", "'1x'", "number"}));
  EXPECT_TRUE(
      seiche::test::tells(error_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 1e999"), {"t.stl:4", "'1e999'"}));
  EXPECT_TRUE(
      seiche::test::tells(error_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 nan"), {"t.stl:4", "'nan'"}));
  EXPECT_TRUE(seiche::test::tells(error_of("solid a\nfacet normal 0 0 1\n"), {"t.stl:3", "ends", "'outer'"}));
  EXPECT_TRUE(seiche::test::tells(error_of("solid a\nfacets\n"), {"t.stl:2", "'facets'", "'endsolid'"}));
  EXPECT_TRUE(seiche::test::tells(error_of("solid a\nendsolid a\n"), {"t.stl", "no triangle"}));
  EXPECT_TRUE(seiche::test::tells(error_of("x,y\n0,1\n"), {"t.stl", "STL"}));
}

/// Damages a file at random places: the reader then throws BadScene or returns a sound mesh.
TEST(StlFile, OutlivesAnyDamage) {
  std::mt19937 random(13);
  const auto any = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  int refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string bytes = k % 2 ? text_stl() : binary_stl(tetrahedron(), k % 4 ? "solid" : "");
    for (std::size_t damage = 1 + any(4); damage > 0 && !bytes.empty(); --damage) switch (any(4)) {
        case 0:
          bytes[any(bytes.size())] = static_cast<char>(any(256));
          break;
        case 1:
          bytes.erase(any(bytes.size()), any(60));
          break;
        case 2:
          bytes.insert(any(bytes.size()), bytes.substr(any(bytes.size()), any(60)));
          break;
        default:
          bytes.resize(1 + any(bytes.size()));
      }
    try {
      const SurfaceMesh mesh = parse_stl(bytes, "t.stl", LengthUnit::mm).mesh;
      for (const auto& point : mesh.points)
        for (const double x : point) ASSERT_TRUE(std::isfinite(x));
      for (const auto& patch : mesh.patches)
        for (const auto& face : patch.faces)
          for (const int at : face) ASSERT_LT(static_cast<std::size_t>(at), mesh.points.size());
    } catch (const BadScene&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10000);
  EXPECT_LT(refused, 20000);
}

TEST(StlFile, IsReadFromAFile) {
  const seiche::test::Scratch scratch;
  seiche::test::write_text(scratch / "t.stl", text_stl());
  EXPECT_EQ(read_stl_file((scratch / "t.stl").string(), LengthUnit::m).mesh.points.size(), 4U);
  EXPECT_THROW(read_stl_file((scratch / "u.stl").string(), LengthUnit::m), BadScene);
  EXPECT_THROW(read_stl_file(scratch.folder().string(), LengthUnit::m), BadScene);
}

}  // namespace
}  // namespace seiche::apps
