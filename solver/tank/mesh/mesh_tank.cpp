#include "solver/tank/mesh/mesh_tank.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/mesh/lining.hpp"
#include "solver/tank/shapes/section.hpp"

namespace seiche::solver {

MeshTank::MeshTank(const SurfaceMesh& surface, double widest_hole)
    : wall_(std::make_shared<const MeshSurface>(mended(surface, widest_hole))), bounds_(wall_->mesh().bounds()) {
  for (const auto& patch : surface.patches) patches_.push_back(patch.name);
}

Nearest<3> MeshTank::nearest(const Vec<3>& r) const {
  const Foot foot = wall_->foot(r);
  const Creases& creases = wall_->creases();
  const Vec<3> off = r - foot.at;
  const double distance = std::sqrt(foot.squared_distance);
  const bool outside = wall_->is_outside(r, foot);
  Vec<3> normal = creases.normal(foot.triangle);
  if (distance == 0) {
    if (foot.on != Foot::On::face) normal = creases.normals_at(foot).front();
  } else if (outside && creases.is_corner(foot)) {
    const Vecs<3> normals = creases.normals_at(foot);
    normal = *std::max_element(normals.begin(), normals.end(),
                               [&](const Vec<3>& a, const Vec<3>& b) { return a.dot(off) < b.dot(off); });
  } else if (foot.on != Foot::On::face) {
    normal = (outside ? 1 : -1) / distance * off;
  }
  return {outside ? distance : -distance, foot.at, normal, wall_->mesh().patch[foot.triangle]};
}

SurfaceMesh MeshTank::surface() const {
  const Triangles& triangles = wall_->mesh();
  SurfaceMesh mesh;
  for (const std::string& name : patches_) mesh.patches.push_back({name, {}});
  for (const Vec<3>& r : triangles.points) mesh.points.push_back({r[0], r[1], r[2]});
  for (int t = 0; t < triangles.count(); ++t)
    mesh.patches[triangles.patch[t]].faces.emplace_back(triangles.corners[t].begin(), triangles.corners[t].end());
  return mesh;
}

std::string MeshTank::description() const { return described(bounds_); }

std::vector<WallPoint<3>> MeshTank::wall_points(int layers, double l0, double reach) const {
  return lining_of(*wall_, layers, l0, reach);
}

double MeshTank::volume() const {
  double sum = 0;
  const Triangles& mesh = wall_->mesh();
  for (int t = 0; t < mesh.count(); ++t) sum += (mesh.corner(t, 0) - bounds_.low).dot(mesh.area(t)) / 3;
  return sum;
}

double MeshTank::area() const {
  double sum = 0;
  for (int t = 0; t < wall_->mesh().count(); ++t) sum += wall_->mesh().area(t).norm();
  return sum;
}

}  // namespace seiche::solver
