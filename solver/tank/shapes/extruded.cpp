#include "solver/tank/shapes/extruded.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/shapes/crossings.hpp"
#include "solver/tank/shapes/flat_faces.hpp"
#include "solver/tank/shapes/tolerance.hpp"

namespace seiche::solver {
namespace {

Vec<3> lifted(const Vec<2>& r, double z) { return {r[0], r[1], z}; }

std::vector<Face<3>> lifted(const std::vector<Face<2>>& faces) {
  std::vector<Face<3>> all;
  for (const Face<2>& face : faces) all.push_back({lifted(face.normal, 0), face.offset});
  return all;
}

}  // namespace

Extruded::Extruded(Section section, double z_low, double z_high)
    : section_(std::move(section)), z_low_(z_low), z_high_(z_high) {}

Nearest<3> Extruded::nearest(const Vec<3>& r) const {
  const Nearest<2> side = section_.nearest(r.head<2>());
  const bool far = r[2] - z_high_ > z_low_ - r[2];
  const double beyond = far ? r[2] - z_high_ : z_low_ - r[2];
  const bool at_side = side.distance >= beyond;
  Nearest<3> result;
  result.normal = at_side ? lifted(side.normal, 0) : Vec<3>(0, 0, far ? 1 : -1);
  result.patch = at_side ? side.patch : static_cast<int>(section_.patches().size()) + far;
  result.distance =
      side.distance > 0 && beyond > 0 ? std::hypot(side.distance, beyond) : std::max(side.distance, beyond);
  result.foot = r;
  if (side.distance > 0 || at_side) result.foot.head<2>() = side.foot;
  if (beyond > 0 || !at_side) result.foot[2] = far ? z_high_ : z_low_;
  return result;
}

Bounds<3> Extruded::bounds() const {
  const Bounds<2> flat = section_.bounds();
  return {lifted(flat.low, z_low_), lifted(flat.high, z_high_)};
}

SurfaceMesh Extruded::surface() const {
  const SurfaceMesh outline = section_.surface();
  SurfaceMesh mesh;
  const int count = static_cast<int>(outline.points.size());
  for (const double z : {z_low_, z_high_})
    for (const auto& point : outline.points) mesh.points.push_back({point[0], point[1], z});
  for (const auto& patch : outline.patches) {
    mesh.patches.push_back({patch.name, {}});
    for (const auto& line : patch.faces)
      mesh.patches.back().faces.push_back({line[0], line[1], line[1] + count, line[0] + count});
  }
  mesh.patches.push_back({"near", {}});
  mesh.patches.push_back({"far", {}});
  const double tolerance = chord_tolerance * section_.bounds().size().maxCoeff();
  for (const auto& face : flat_faces(section_.wall().polygons(tolerance))) {
    const int first = static_cast<int>(mesh.points.size()), corners = static_cast<int>(face.size());
    std::vector<int> near, far;
    for (int k = 0; k < corners; ++k) {
      mesh.points.push_back({face[static_cast<std::size_t>(k)][0], face[static_cast<std::size_t>(k)][1], z_low_});
      near.insert(near.begin(), first + k);
    }
    for (int k = 0; k < corners; ++k) {
      mesh.points.push_back({face[static_cast<std::size_t>(k)][0], face[static_cast<std::size_t>(k)][1], z_high_});
      far.push_back(first + corners + k);
    }
    mesh.patches[mesh.patches.size() - 2].faces.push_back(near);
    mesh.patches.back().faces.push_back(far);
  }
  return mesh;
}

std::vector<WallPoint<3>> Extruded::wall_points(int layers, double l0, double reach) const {
  std::vector<WallPoint<3>> points;
  const int near = static_cast<int>(section_.patches().size());
  const auto rows = static_cast<int>(std::max(1.0, std::round((z_high_ - z_low_) / l0)));
  const double height = (z_high_ - z_low_) / rows;
  const auto depth = [&](int layer, bool far) {
    return far ? z_high_ + (layer + 0.5) * l0 : z_low_ - (layer + 0.5) * l0;
  };
  for (const WallPoint<2>& side : section_.wall_points(layers, l0, reach)) {
    const std::vector<Face<3>> faces = lifted(side.faces);
    for (int row = 0; row < rows; ++row)
      points.push_back({lifted(side.position, z_low_ + (row + 0.5) * height), lifted(side.normal, 0),
                        side.weight * height / l0, side.layer, side.patch, faces});
    for (int layer = 0; layer < layers; ++layer)
      for (const bool far : {false, true})
        points.push_back({lifted(side.position, depth(layer, far)),
                          Vec<3>::Zero(),
                          side.weight,
                          std::max(side.layer, layer),
                          layer > side.layer ? near + far : side.patch,
                          {}});
  }
  for (const AreaPoint& cell : filled_rows(section_.wall(), l0))
    for (int layer = 0; layer < layers; ++layer)
      for (const bool far : {false, true})
        points.push_back({lifted(cell.position, depth(layer, far)),
                          Vec<3>(0, 0, far ? 1 : -1),
                          cell.area / (l0 * l0),
                          layer,
                          near + far,
                          {}});
  return points;
}

}  // namespace seiche::solver
