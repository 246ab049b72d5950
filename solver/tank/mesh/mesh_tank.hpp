#pragma once
#include <memory>

#include "solver/tank/mesh/mesh_surface.hpp"

namespace seiche::solver {

/// A closed tank in 3-D whose wall is a mesh. Its patches are the mesh's.
class MeshTank final : public Shape<3> {
 public:
  /// @param surface polygons, either way round
  /// @param widest_hole that is closed: a spacing of particles [m]. Throws BadParameters as `mended` does.
  MeshTank(const SurfaceMesh& surface, double widest_hole);

  /// Exact. Behind a corner of the tank the normal is that of the wall which r is farther behind.
  Nearest<3> nearest(const Vec<3>& r) const override;
  Bounds<3> bounds() const override { return bounds_; }
  bool is_closed() const override { return true; }
  SurfaceMesh surface() const override;
  std::string description() const override;
  std::vector<WallPoint<3>> wall_points(int layers, double l0, double reach) const override;

  /// [m^3]
  double volume() const;
  /// [m^2]
  double area() const;
  const MeshFaults& faults() const { return wall_->faults(); }
  const MeshSurface& wall() const { return *wall_; }
  const std::vector<std::string>& patches() const { return patches_; }

 private:
  std::shared_ptr<const MeshSurface> wall_;
  std::vector<std::string> patches_;
  Bounds<3> bounds_;
};

}  // namespace seiche::solver
