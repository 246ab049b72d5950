#include "solver/tank/level.hpp"

#include <Eigen/Geometry>
#include <limits>

namespace seiche::solver {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

Corners corners_of(const SurfaceMesh& wall, const std::vector<int>& face) {
  Corners corners;
  for (const int k : face) corners.emplace_back(wall.points[static_cast<std::size_t>(k)].data());
  return corners;
}

/// The part of a segment or a polygon with y <= level.
Corners clipped(const Corners& corners, double level) {
  Corners kept;
  const std::size_t count = corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d &here = corners[k], &next = corners[(k + 1) % count];
    if (here[1] <= level) kept.push_back(here);
    if (count == 2 && k == 1) break;
    if ((here[1] <= level) != (next[1] <= level))
      kept.push_back(here + (level - here[1]) / (next[1] - here[1]) * (next - here));
  }
  return kept;
}

/// Integral of x n_x over a face.
double flux(const Corners& corners) {
  if (corners.size() == 2) return 0.5 * (corners[0][0] + corners[1][0]) * (corners[1][1] - corners[0][1]);
  double sum = 0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const Eigen::Vector3d area = 0.5 * (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]);
    sum += (corners[0][0] + corners[k - 1][0] + corners[k][0]) / 3 * area[0];
  }
  return sum;
}

double area(const Corners& corners) {
  if (corners.size() == 2) return (corners[1] - corners[0]).norm();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += 0.5 * (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]);
  return sum.norm();
}

template <class Of>
double sum_over(const SurfaceMesh& wall, Of of) {
  double sum = 0;
  for (const SurfaceMesh::Patch& patch : wall.patches)
    for (const std::vector<int>& face : patch.faces) sum += of(corners_of(wall, face));
  return sum;
}

}  // namespace

double volume_below(const SurfaceMesh& wall, double level) {
  return sum_over(wall, [&](const Corners& corners) { return flux(clipped(corners, level)); });
}

double volume_of(const SurfaceMesh& wall) { return volume_below(wall, std::numeric_limits<double>::infinity()); }

double area_of(const SurfaceMesh& wall) { return sum_over(wall, area); }

double level_holding(const SurfaceMesh& wall, double volume) {
  double low = wall.low()[1], high = wall.high()[1];
  const double finest = 1e-13 * (high - low);
  if (volume_below(wall, high) <= volume) return high;
  while (high - low > finest) {
    const double middle = 0.5 * (low + high);
    (volume_below(wall, middle) < volume ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace seiche::solver
