#include "solver/tank/mesh/edges.hpp"

#include <algorithm>
#include <tuple>

namespace seiche::solver {

std::vector<MeshEdge> edges_of(const Triangles& mesh) {
  struct Use {
    int low, high;
    Side side;
  };
  std::vector<Use> uses;
  for (int t = 0; t < mesh.count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({mesh.corners[t][k], mesh.corners[t][(k + 1) % 3]});
      uses.push_back({low, high, {t, k}});
    }
  const auto place = [](const Use& use) { return std::tuple(use.low, use.high, use.side.triangle); };
  std::sort(uses.begin(), uses.end(), [&](const Use& a, const Use& b) { return place(a) < place(b); });
  std::vector<MeshEdge> edges;
  for (const Use& use : uses) {
    if (edges.empty() || edges.back().low != use.low || edges.back().high != use.high)
      edges.push_back({use.low, use.high, {}});
    edges.back().sides.push_back(use.side);
  }
  return edges;
}

}  // namespace seiche::solver
