#include "solver/tank/shapes/section.hpp"

#include <fmt/format.h>

#include "solver/tank/shapes/layer.hpp"
#include "solver/tank/shapes/tolerance.hpp"

namespace seiche::solver {

Section::Section(Contour wall, std::vector<std::string> patches)
    : wall_(std::move(wall)), patches_(std::move(patches)), bends_(wall_), bounds_(wall_.bounds()) {}

SurfaceMesh Section::surface() const {
  SurfaceMesh mesh;
  for (const std::string& name : patches_) mesh.patches.push_back({name, {}});
  for (const auto& corners : wall_.polygons(chord_tolerance * bounds_.size().maxCoeff())) {
    const int first = static_cast<int>(mesh.points.size()), count = static_cast<int>(corners.size());
    for (int k = 0; k < count; ++k) {
      const auto& corner = corners[static_cast<std::size_t>(k)];
      mesh.points.push_back({corner.position[0], corner.position[1], 0});
      mesh.patches[static_cast<std::size_t>(corner.patch)].faces.push_back({first + k, first + (k + 1) % count});
    }
  }
  return mesh;
}

template <int D>
std::string described(const Bounds<D>& bounds) {
  std::string text;
  for (int axis = 0; axis < D; ++axis)
    text += fmt::format("{}{} from {:.6g} to {:.6g} m", axis > 0 ? ", " : "", "xyz"[axis], bounds.low[axis],
                        bounds.high[axis]);
  return D == 2 ? text + ", and has no z" : text;
}

template std::string described(const Bounds<2>& bounds);
template std::string described(const Bounds<3>& bounds);

std::string Section::description() const { return described(bounds_); }

std::vector<WallPoint<2>> Section::wall_points(int layers, double l0, double reach) const {
  std::vector<WallPoint<2>> points;
  for (int layer = 0; layer < layers; ++layer)
    for (const LayerPoint& point : layer_points(wall_, layer, layer + 1 == layers, l0)) {
      Behind behind = bends_.behind(wall_, point.position, reach);
      points.push_back(
          {point.position, behind.normal, point.length / l0, layer, behind.patch, std::move(behind.faces)});
    }
  return points;
}

}  // namespace seiche::solver
