#include "solver/tank/mesh/shell.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/mesh/cut_cube.hpp"

namespace seiche::solver {
namespace {

/// Cubes along a block of l0.
constexpr int cubes = 4;
/// From the middle of a block to a corner [l0].
constexpr double half_diagonal = 0.8661;

using Layers = std::vector<std::vector<ShellPiece>>;

void add_cube(const MeshSurface& surface, const Vec<3>& at, double within, double l0, Layers& layers) {
  const double side = l0 / cubes;
  const Depth depth = surface.depth(at, within);
  // A cube reaches that far before and behind its middle.
  const double reach = 0.5 * side * depth.way.lpNorm<1>();
  const int count = static_cast<int>(layers.size());
  const int first = std::max(0, static_cast<int>(std::floor((depth.at - reach) / l0))),
            last = std::min(count - 1, static_cast<int>(std::floor((depth.at + reach) / l0)));
  for (int k = first; k <= last; ++k) {
    const double share =
        share_below(depth.way, ((k + 1) * l0 - depth.at) / side) - share_below(depth.way, (k * l0 - depth.at) / side);
    if (share > 1e-6)
      layers[k].push_back({at, static_cast<float>(share / (cubes * cubes * cubes)), static_cast<float>(depth.at)});
  }
}

void add_block(const MeshSurface& surface, const Vec<3>& middle, double l0, Layers& layers) {
  const Depth depth = surface.depth(middle);
  const double reach = half_diagonal * l0;
  if (depth.at < -reach || depth.at > static_cast<double>(layers.size()) * l0 + reach) return;
  const double distance = std::sqrt(depth.foot.squared_distance);
  const auto along = [&](int k) { return ((k + 0.5) / cubes - 0.5) * l0; };
  for (int x = 0; x < cubes; ++x)
    for (int y = 0; y < cubes; ++y)
      for (int z = 0; z < cubes; ++z) {
        const Vec<3> off(along(x), along(y), along(z));
        add_cube(surface, middle + off, distance + 1.0001 * off.norm(), l0, layers);
      }
}

}  // namespace

Layers shell_of(const MeshSurface& surface, int layers, double l0) {
  const Bounds<3> bounds = surface.mesh().bounds();
  const Vec<3> low = bounds.low - Vec<3>::Constant(layers * l0);
  const Eigen::Vector3i count = ((bounds.size() / l0).array().ceil().cast<int>() + 2 * layers).matrix();
  // Blocks of a column are put together in their order, whatever the threads.
  const int columns = count[0] * count[1];
  std::vector<Layers> of_column(columns, Layers(layers));
#pragma omp parallel for schedule(dynamic, 16)
  for (int column = 0; column < columns; ++column)
    for (int z = 0; z < count[2]; ++z) {
      const Vec<3> cell(column % count[0] + 0.5, column / count[0] + 0.5, z + 0.5);
      add_block(surface, low + l0 * cell, l0, of_column[column]);
    }
  Layers all(layers);
  for (Layers& column : of_column) {
    for (int k = 0; k < layers; ++k) all[k].insert(all[k].end(), column[k].begin(), column[k].end());
    column.clear();
  }
  return all;
}

}  // namespace seiche::solver
