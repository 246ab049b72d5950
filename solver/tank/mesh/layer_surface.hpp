#pragma once
#include <optional>
#include <vector>

#include "solver/tank/mesh/mesh_surface.hpp"

namespace seiche::solver {

/// The surface that lies at a depth behind a tank's wall.
class LayerSurface {
 public:
  /// @param depth [m]
  LayerSurface(const MeshSurface& wall, double depth) : wall_(&wall), depth_(depth) {}

  double depth() const { return depth_; }

  /// The point on it that r is before or behind; none where another part of the wall is nearer, as in a solid that is
  /// too thin for it. Beside an edge of the solid, the point where two layers meet.
  std::optional<Vec<3>> place(Vec<3> r) const;

  /// Points at its mitres, behind the corners of the tank: where mitres meet, and between, in steps of about `spacing`.
  Vecs<3> mitre_points(double spacing) const;

 private:
  std::optional<Vec<3>> behind(int point) const;

  const MeshSurface* wall_;
  double depth_;
};

}  // namespace seiche::solver
