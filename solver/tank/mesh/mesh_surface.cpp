#include "solver/tank/mesh/mesh_surface.hpp"

#include <cmath>

namespace seiche::solver {

MeshSurface::MeshSurface(Mended mended)
    : mended_(std::move(mended)), creases_(mended_.mesh), closest_(mended_.mesh), winding_(mended_.mesh) {}

bool MeshSurface::is_outside(const Vec<3>& r, const Foot& foot) const {
  return mended_.simple ? (r - foot.at).dot(creases_.pseudonormal(foot)) > 0 : winding_.number(r) < 0.5;
}

Depth MeshSurface::depth(const Vec<3>& r, double within) const {
  const Foot foot = closest_.foot(r, within);
  const Vec<3> off = r - foot.at;
  const double distance = std::sqrt(foot.squared_distance);
  if (distance == 0) return {0, creases_.pseudonormal(foot).normalized(), foot};
  const bool outside = is_outside(r, foot);
  if (outside && creases_.is_corner(foot)) {
    const double mitre = foot.on == Foot::On::side ? side_mitre : point_mitre;
    Depth deepest{distance / mitre, off / (distance * mitre), foot};
    for (const Vec<3>& normal : creases_.normals_at(foot))
      if (const double behind = normal.dot(off); behind > deepest.at) deepest.at = behind, deepest.way = normal;
    return deepest;
  }
  const double sign = outside ? 1 : -1;
  const Vec<3> way = foot.on == Foot::On::face ? creases_.normal(foot.triangle) : Vec<3>(sign / distance * off);
  return {sign * distance, way, foot};
}

}  // namespace seiche::solver
