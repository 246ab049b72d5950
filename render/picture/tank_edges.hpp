#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "solver/surface_mesh.hpp"

namespace seiche::render {

/// The edges that show the form of a surface in 3-D: where faces meet at more than 30 degrees, rims, and where the
/// surface turns away from the camera. From end to end [m].
/// @param to_camera from anywhere
std::vector<std::array<Eigen::Vector3d, 2>> tank_edges(const SurfaceMesh& tank, const Eigen::Vector3d& to_camera);

}  // namespace seiche::render
