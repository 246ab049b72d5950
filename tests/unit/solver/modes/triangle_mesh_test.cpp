#include "solver/modes/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include "solver/modes/ears.hpp"
#include "solver/modes/element_size.hpp"
#include "solver/modes/refine.hpp"
#include "solver/tank/edge.hpp"
#include "tests/unit/solver/modes/sections.hpp"

namespace seiche::solver::modes {
namespace {

TriangleMesh coarse(const Outline& outline) {
  const Walk walk = joined(outline);
  std::vector<Vec<2>> points;
  std::vector<bool> surface;
  for (const Corner& corner : walk.corners) {
    points.push_back(corner.at);
    surface.push_back(corner.surface);
  }
  TriangleMesh mesh(points, ears(walk, outline), surface);
  mesh.place(outline.origin, outline.unit);
  return mesh;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    const double twice = cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    EXPECT_GT(twice, 0);
    sum += 0.5 * twice;
  }
  return sum;
}

double surface(const TriangleMesh& mesh) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.triangles()[static_cast<std::size_t>(t)].across[static_cast<std::size_t>(k)] == TriangleMesh::surface)
        sum += std::sqrt(mesh.squared_length(t, k));
  return sum;
}

/// Expects that neighbours know each other and that no corner beyond an edge lies in the circle of a triangle.
void expect_delaunay(const TriangleMesh& mesh) {
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.triangles()[static_cast<std::size_t>(t)].across[static_cast<std::size_t>(k)];
      if (n < 0) continue;
      const int m = mesh.shared(n, t);
      ASSERT_EQ(mesh.triangles()[static_cast<std::size_t>(n)].across[static_cast<std::size_t>(m)], t);
      EXPECT_EQ(mesh.corner(t, k + 1), mesh.corner(n, m + 2));
      EXPECT_EQ(mesh.corner(t, k + 2), mesh.corner(n, m + 1));
      const auto angle = [&](int of, int at) {
        const Vec<2> a = mesh.corner(of, at + 1) - mesh.corner(of, at),
                     b = mesh.corner(of, at + 2) - mesh.corner(of, at);
        return std::atan2(cross(a, b), a.dot(b));
      };
      EXPECT_LT(angle(t, k) + angle(n, m), std::numbers::pi + 1e-7);
    }
}

TEST(TriangleMesh, IsDelaunayAndStaysSo) {
  for (const Polygons& section :
       {test::box(0.5, 0.3), test::circle(0.25, 100), test::baffled(0.02), test::baffled(0)}) {
    TriangleMesh mesh = coarse(liquid_below(0.2, section)[0]);
    const double whole = area(mesh), open = surface(mesh);
    expect_delaunay(mesh);
    for (int t = 0; t < 60; ++t) mesh.split(t % static_cast<int>(mesh.triangles().size()), t % 3);
    expect_delaunay(mesh);
    EXPECT_NEAR(area(mesh), whole, 1e-12);
    EXPECT_NEAR(surface(mesh), open, 1e-12);
  }
}

TEST(TriangleMesh, IsRefinedToTheSize) {
  TriangleMesh mesh = coarse(liquid_below(0.2, test::baffled(0))[0]);
  const auto size = [](const Vec<2>& at) { return 1e-4 + 0.3 * (at - Vec<2>(0.25, 0.1)).norm(); };
  refine(mesh, size);
  expect_delaunay(mesh);
  EXPECT_NEAR(area(mesh), 0.1, 1e-8);
  EXPECT_LT(mesh.triangles().size(), 4000u);
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    const Vec<2> centroid = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::sqrt(mesh.squared_length(t, k)), size(centroid) * (1 + 1e-12));
  }
}

TEST(TriangleMesh, SizeIsShortAtCornersThatStickOut) {
  const Outline outline = liquid_below(0.2, test::baffled(0.02))[0];
  const ElementSize size(outline, 20, 1);
  const auto at = [&](double x, double y) {
    return outline.unit * size((Vec<2>(x, y) - outline.origin) / outline.unit);
  };
  const double at_surface = 0.5 / 20;
  EXPECT_NEAR(at(0.02, 0.2), at_surface, 1e-6);
  EXPECT_NEAR(at(0.24, 0.1), 1e-3 * at_surface, 1e-6);  // 270 degrees
  EXPECT_GT(at(0.02, 0.1), at_surface);
  EXPECT_NEAR(outline.unit * ElementSize(outline, 20, 1e-3)(Vec<2>(0, 0.2 / outline.unit)), 1e-3, 1e-6);
}

}  // namespace
}  // namespace seiche::solver::modes
