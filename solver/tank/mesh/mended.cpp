#include "solver/tank/mesh/mended.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/errors.hpp"
#include "solver/tank/mesh/edges.hpp"
#include "solver/tank/mesh/orient.hpp"
#include "solver/tank/mesh/slivers.hpp"
#include "solver/tank/mesh/winding_tree.hpp"

namespace seiche::solver {
namespace {

constexpr double sliver_height = 1e-6;    // of the mesh's size
constexpr double stitch_distance = 1e-5;  // the same
constexpr double least_overlap = 1e-3;    // of its area

std::string place(const Vec<3>& at) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", at[0], at[1], at[2]); }

[[noreturn]] void refuse(const Triangles& mesh, const MeshEdge& edge) {
  throw BadParameters(fmt::format(
      "{} triangles of the mesh meet at the side from {} to {}, as where a sheet without thickness meets a wall; leave "
      "the sheet out, or give it a thickness",
      edge.sides.size(), place(mesh.points[edge.low]), place(mesh.points[edge.high])));
}

void check_no_sheet(const Triangles& mesh) {
  for (const MeshEdge& edge : edges_of(mesh))
    if (edge.sides.size() > 1 && edge.sides.size() % 2 == 1) refuse(mesh, edge);
}

/// Whether no side has more than two triangles. Throws where those of a side don't cancel.
bool has_pairs_only(const Triangles& mesh) {
  bool pairs = true;
  for (const MeshEdge& edge : edges_of(mesh)) {
    int balance = 0;
    for (const Side& side : edge.sides) balance += begin_of(mesh, side) == edge.low ? 1 : -1;
    if (balance != 0) refuse(mesh, edge);
    pairs &= edge.sides.size() == 2;
  }
  return pairs;
}

/// Whether all triangles have liquid on one side and none on the other. Throws where more than a few haven't.
bool bounds_liquid(const Triangles& mesh) {
  const WindingTree tree(mesh);
  const auto is_wrong = [&](int t) {
    const Vec<3> area = mesh.area(t);
    if (area.isZero()) return false;
    const Vec<3> step = 1e-3 / std::sqrt(area.norm()) * area;
    return tree.number(mesh.centre(t) + step) > 0.5 || tree.number(mesh.centre(t) - step) < 0.5;
  };
  std::vector<char> wrong(mesh.count());
#pragma omp parallel for schedule(dynamic, 256)
  for (int t = 0; t < mesh.count(); ++t) wrong[t] = is_wrong(t);
  double all = 0, out = 0, largest = 0;
  Vec<3> at = Vec<3>::Zero();
  for (int t = 0; t < mesh.count(); ++t) {
    const double area = mesh.area(t).norm();
    all += area;
    if (!wrong[t]) continue;
    out += area;
    if (area > largest) largest = area, at = mesh.centre(t);
  }
  if (out > least_overlap * all)
    throw BadParameters(
        fmt::format("parts of the mesh overlap or cross each other near {}: join them to one surface in the program "
                    "that made the mesh",
                    place(at)));
  return out == 0;
}

}  // namespace

Mended mended(const SurfaceMesh& surface, double widest) {
  Mended result;
  Triangles& mesh = result.mesh;
  MeshFaults& faults = result.faults;
  mesh = triangles_of(surface, faults.left_out);
  const double size = Vec<3>(surface.size().data()).norm();
  faults.slivers = take_out_slivers(mesh, sliver_height * size);
  faults.slivers += cut_at_points_on_sides(mesh, stitch_distance * size);
  if (mesh.count() == 0) throw BadParameters("the mesh has no triangle with an area; give the surface of the tank");
  const std::vector<std::array<int, 3>> given = mesh.corners;
  check_no_sheet(mesh);
  face_one_way(mesh);
  faults.holes = close_holes(mesh, widest);
  face_outwards(mesh, face_one_way(mesh));
  for (std::size_t t = 0; t < given.size(); ++t) faults.turned += mesh.corners[t] != given[t];
  result.simple = has_pairs_only(mesh);
  result.simple &= bounds_liquid(mesh);
  return result;
}

}  // namespace seiche::solver
