#pragma once
#include <vector>

#include "solver/particles/vec.hpp"
#include "solver/surface_mesh.hpp"

namespace seiche::solver {

/// A piece of the wall about as large as a particle, as points of a quadrature.
template <int D>
struct Facet {
  struct Point {
    Vec<D> offset;  ///< from the centre [m]
    Vec<D> area;    ///< that it stands for, along the normal out of the tank [m in 2-D, m^2]
  };
  Vec<D> centre = Vec<D>::Zero();  ///< [m]
  int patch = 0;                   ///< of the wall that it is on, by its place in the mesh
  std::vector<Point> points;
};

/// The wall in facets no larger than l0 on each axis; integrals over them are exact for quadratic functions where the
/// wall is flat: segments of at most l0/2 with two Gauss points, triangles within cubes of l0/2 with the middles of
/// their edges.
template <int D>
std::vector<Facet<D>> facets_of(const SurfaceMesh& wall, double l0);

}  // namespace seiche::solver
