#pragma once
#include <array>
#include <vector>

#include "solver/surface_mesh.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// A surface of triangles that share their corners.
struct Triangles {
  Vecs<3> points;                           ///< [m]
  std::vector<std::array<int, 3>> corners;  ///< places in `points`, counter-clockwise as seen from outside
  std::vector<int> patch;                   ///< of each triangle

  int count() const { return static_cast<int>(corners.size()); }
  const Vec<3>& corner(int triangle, int k) const { return points[corners[triangle][k]]; }
  Vec<3> centre(int triangle) const;
  /// Its area along its normal [m^2].
  Vec<3> area(int triangle) const;
  /// Box that holds it [m].
  Bounds<3> box(int triangle) const;
  Bounds<3> bounds() const;
  void add(const std::array<int, 3>& at, int of_patch);
};

/// a x b, which Eigen has in a header that takes long to compile.
inline Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What was left out of a mesh.
struct LeftOut {
  int degenerate = 0;  ///< triangles with two corners in one place
  int doubles = 0;     ///< triangles that were there before, either way round
};

/// The faces of a mesh as triangles. Points within 1e-7 of the mesh's size become one.
Triangles triangles_of(const SurfaceMesh& mesh, LeftOut& left_out);

}  // namespace seiche::solver
