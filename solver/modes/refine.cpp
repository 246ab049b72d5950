#include "solver/modes/refine.hpp"

namespace seiche::solver::modes {
namespace {

int longest_edge(const TriangleMesh& mesh, int t) {
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (mesh.squared_length(t, k) > mesh.squared_length(t, longest)) longest = k;
  return longest;
}

void split_on_path(TriangleMesh& mesh, int t) {
  for (;;) {
    const int k = longest_edge(mesh, t);
    const int beyond = mesh.triangles()[static_cast<std::size_t>(t)].across[static_cast<std::size_t>(k)];
    constexpr double tie = 1 + 1e-12;
    if (beyond < 0 || mesh.squared_length(beyond, longest_edge(mesh, beyond)) <= tie * mesh.squared_length(t, k))
      return mesh.split(t, k);
    t = beyond;
  }
}

}  // namespace

void refine(TriangleMesh& mesh, const std::function<double(const Vec<2>&)>& size) {
  const auto is_long = [&](int t) {
    const Vec<2> centroid = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
    const double limit = size(centroid);
    return mesh.squared_length(t, longest_edge(mesh, t)) > limit * limit;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t)
      while (is_long(t)) {
        split_on_path(mesh, t);
        changed = true;
      }
  }
}

}  // namespace seiche::solver::modes
