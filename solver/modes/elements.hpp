#pragma once
#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "solver/modes/triangle_mesh.hpp"

namespace seiche::solver::modes {

/// How the potential depends on the coordinate across the section.
struct Across {
  bool revolved = false;   ///< the section's first coordinate is the radius: phi goes with cos(m theta)
  int m = 0;               ///< waves round the axis, if revolved
  double wave_number = 0;  ///< k of phi that goes with cos(k z), if not [rad/m]
};

/// Quadratic triangles for a K u = lambda M u on the free surface, lambda = omega^2 / g [1/m]:
/// K = integral of grad u . grad v + k^2 u v, M = integral of u v along the surface; of a body of revolution
/// K = integral of r grad u . grad v + m^2 / r u v, M = integral of r u v, with u = 0 on the axis unless m = 0.
struct Elements {
  Eigen::SparseMatrix<double> inner;     ///< K of the nodes below the surface
  Eigen::SparseMatrix<double> coupling;  ///< of those below, by those on it
  Eigen::MatrixXd outer;                 ///< of the nodes on the surface
  Eigen::MatrixXd mass;                  ///< M
  std::vector<double> across;            ///< first coordinate of each node on the surface [m]
};

Elements assemble(const TriangleMesh& mesh, const Across& across);

}  // namespace seiche::solver::modes
