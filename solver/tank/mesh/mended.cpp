#include "solver/tank/mesh/mended.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"
#include "solver/tank/mesh/edges.hpp"
#include "solver/tank/mesh/orient.hpp"
#include "solver/tank/mesh/self_crossing.hpp"
#include "solver/tank/mesh/slivers.hpp"

namespace seiche::solver {
namespace {

constexpr double sliver_height = 1e-6;    // of the mesh's size
constexpr double stitch_distance = 1e-5;  // the same
constexpr double shallow = 0.1;           // of the widest hole: how far parts may pass through each other

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

}  // namespace

std::string text_of(const MeshFaults& faults) {
  std::string text;
  const auto add = [&](int count, const char* what, const char* done) {
    if (count > 0)
      text += fmt::format("{}{} {}{} {}", text.empty() ? "" : "; ", count, what, count > 1 ? "s" : "", done);
  };
  add(faults.left_out.degenerate + faults.slivers, "triangle", "without an area taken out or joined to others");
  add(faults.left_out.doubles, "triangle", "left out, there twice");
  add(faults.turned, "triangle", "turned round");
  add(faults.holes.count, "hole", "closed");
  if (faults.holes.count > 0) text += fmt::format(", the widest {:.3g} m across", faults.holes.widest);
  return text;
}

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
  const SelfCrossing crossing = self_crossing(mesh);
  if (crossing.depth > shallow * widest)
    throw BadParameters(
        fmt::format("the mesh passes through itself at {}: join its parts to one surface in the program that made it",
                    place(crossing.at)));
  result.simple &= crossing.depth == 0;
  return result;
}

}  // namespace seiche::solver
