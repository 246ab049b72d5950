#include "solver/modes/nodes.hpp"

#include <algorithm>

namespace seiche::solver::modes {
namespace {

/// Six node numbers a triangle: points keep theirs, edges come after them.
std::vector<std::array<int, 6>> numbered(const TriangleMesh& mesh, int& count) {
  std::vector<std::array<int, 6>> of(mesh.triangles().size());
  count = static_cast<int>(mesh.points().size());
  for (std::size_t t = 0; t < of.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int self = static_cast<int>(t), beyond = mesh.triangles()[t].across[k];
      of[t][k] = mesh.triangles()[t].corners[k];
      of[t][3 + k] =
          beyond < 0 || beyond > self
              ? count++
              : of[static_cast<std::size_t>(beyond)][3 + static_cast<std::size_t>(mesh.shared(beyond, self))];
    }
  return of;
}

}  // namespace

Nodes::Nodes(const TriangleMesh& mesh, bool hold_axis) : of_(mesh.triangles().size()) {
  int count = 0;
  const auto numbers = numbered(mesh, count);
  std::vector<double> first(static_cast<std::size_t>(count));
  std::vector<bool> on_surface(first.size(), false);
  for (std::size_t t = 0; t < numbers.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<std::size_t, 2> ends{(k + 1) % 3, (k + 2) % 3};
      const auto node = [&](std::size_t place) { return static_cast<std::size_t>(numbers[t][place]); };
      first[node(k)] = mesh.points()[node(k)][0];
      first[node(3 + k)] = 0.5 * (mesh.points()[node(ends[0])][0] + mesh.points()[node(ends[1])][0]);
      if (mesh.triangles()[t].across[k] == TriangleMesh::surface)
        for (const std::size_t place : {ends[0], ends[1], 3 + k}) on_surface[node(place)] = true;
    }

  std::vector<int> of_surface;
  std::vector<Place> places(first.size(), Place{-1, false});
  for (std::size_t node = 0; node < first.size(); ++node) {
    if (hold_axis && first[node] == 0) continue;
    if (on_surface[node])
      of_surface.push_back(static_cast<int>(node));
    else
      places[node] = {below_++, false};
  }
  const auto at = [&](int node) { return first[static_cast<std::size_t>(node)]; };
  std::stable_sort(of_surface.begin(), of_surface.end(), [&](int a, int b) { return at(a) < at(b); });
  for (const int node : of_surface) {
    places[static_cast<std::size_t>(node)] = {static_cast<int>(on_surface_.size()), true};
    on_surface_.push_back(at(node));
  }
  for (std::size_t t = 0; t < numbers.size(); ++t)
    for (std::size_t k = 0; k < 6; ++k) of_[t][k] = places[static_cast<std::size_t>(numbers[t][k])];
}

}  // namespace seiche::solver::modes
