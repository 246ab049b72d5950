#include "solver/tank/mesh/orient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/errors.hpp"
#include "solver/tank/mesh/edges.hpp"
#include "solver/tank/mesh/winding_tree.hpp"

namespace seiche::solver {
namespace {

/// Of each side of each triangle the one beyond, if there is just one.
std::vector<std::array<Side, 3>> neighbours(const Triangles& mesh) {
  std::vector<std::array<Side, 3>> all(mesh.count(), {Side{-1, 0}, Side{-1, 0}, Side{-1, 0}});
  for (const MeshEdge& edge : edges_of(mesh)) {
    if (edge.sides.size() != 2) continue;
    const Side &a = edge.sides[0], &b = edge.sides[1];
    all[a.triangle][a.k] = b;
    all[b.triangle][b.k] = a;
  }
  return all;
}

/// Whether two neighbours, of which some may have been turned, face one way.
bool agree(const Triangles& mesh, const Side& a, const Side& b, bool turned_a, bool turned_b) {
  return are_opposite(mesh, a, b) == (turned_a == turned_b);
}

struct Part {
  std::vector<int> triangles;
  Bounds<3> bounds;
  Vec<3> place;  ///< on its largest triangle
  double volume = 0;
};

std::vector<Part> parts_of(const Triangles& mesh, const std::vector<int>& part) {
  std::vector<Part> parts(part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1);
  std::vector<double> largest(parts.size(), -1);
  const Vec<3> origin = mesh.points[mesh.corners[0][0]];
  for (int t = 0; t < mesh.count(); ++t) {
    Part& one = parts[part[t]];
    const Bounds<3> box = mesh.box(t);
    const Vec<3> area = mesh.area(t);
    if (one.triangles.empty()) one.bounds = box;
    one.bounds.low = one.bounds.low.cwiseMin(box.low);
    one.bounds.high = one.bounds.high.cwiseMax(box.high);
    one.triangles.push_back(t);
    one.volume += (mesh.centre(t) - origin).dot(area) / 3;
    if (area.norm() > largest[part[t]]) largest[part[t]] = area.norm(), one.place = mesh.centre(t);
  }
  return parts;
}

bool holds(const Triangles& mesh, const Part& part, const Vec<3>& r) {
  if ((r.array() < part.bounds.low.array()).any() || (r.array() > part.bounds.high.array()).any()) return false;
  double angle = 0;
  for (const int t : part.triangles)
    angle += solid_angle(mesh.corner(t, 0) - r, mesh.corner(t, 1) - r, mesh.corner(t, 2) - r);
  return std::abs(angle) > 2 * std::numbers::pi;
}

}  // namespace

void turn(Triangles& mesh, int triangle) { std::swap(mesh.corners[triangle][1], mesh.corners[triangle][2]); }

std::vector<int> face_one_way(Triangles& mesh) {
  const auto beyond = neighbours(mesh);
  std::vector<int> part(mesh.count(), -1), next;
  std::vector<bool> turned(mesh.count());
  int parts = 0;
  for (int first = 0; first < mesh.count(); ++first) {
    if (part[first] >= 0) continue;
    part[first] = parts;
    next.assign(1, first);
    while (!next.empty()) {
      const int t = next.back();
      next.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Side& other = beyond[t][k];
        if (other.triangle < 0) continue;
        const bool same = agree(mesh, {t, k}, other, turned[t], turned[other.triangle]);
        if (part[other.triangle] < 0) {
          if (!same) turned[other.triangle] = !turned[other.triangle];
          part[other.triangle] = parts;
          next.push_back(other.triangle);
        } else if (!same) {
          const Vec<3> at = mesh.centre(t);
          throw BadParameters(
              fmt::format("the mesh has a surface with one side only, as a Moebius strip has, near ({:.6g}, {:.6g}, "
                          "{:.6g}) m; mend "
                          "it in the program that made it",
                          at[0], at[1], at[2]));
        }
      }
    }
    ++parts;
  }
  for (int t = 0; t < mesh.count(); ++t)
    if (turned[t]) turn(mesh, t);
  return part;
}

void face_outwards(Triangles& mesh, const std::vector<int>& part) {
  const std::vector<Part> parts = parts_of(mesh, part);
  for (const Part& one : parts) {
    bool hole = false;
    for (const Part& other : parts)
      if (&other != &one && holds(mesh, other, one.place)) hole = !hole;
    if ((one.volume < 0) == hole) continue;
    for (const int t : one.triangles) turn(mesh, t);
  }
}

}  // namespace seiche::solver
