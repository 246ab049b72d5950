#pragma once
#include <array>
#include <vector>

#include "solver/modes/triangle_mesh.hpp"

namespace seiche::solver::modes {

/// The unknowns of quadratic triangles, at corners and in the middles of edges: those on the free surface, from low to
/// high first coordinate, and those below.
class Nodes {
 public:
  struct Place {
    int row;  ///< among those on the surface or those below; -1 if held at 0
    bool on_surface;
  };

  /// @param hold_axis whether nodes whose first coordinate is 0 are held at 0
  Nodes(const TriangleMesh& mesh, bool hold_axis);

  /// Corners, then middles of the edges opposite to them.
  const std::array<Place, 6>& of(int triangle) const { return of_[static_cast<std::size_t>(triangle)]; }
  int below() const { return below_; }
  /// First coordinate of each.
  const std::vector<double>& on_surface() const { return on_surface_; }

 private:
  std::vector<std::array<Place, 6>> of_;
  std::vector<double> on_surface_;
  int below_ = 0;
};

}  // namespace seiche::solver::modes
