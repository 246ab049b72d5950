#include "solver/tank/shapes/mirrored.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

using Edges = std::vector<Edge>;

/// The mirror image, the other way round.
Edge image(const Edge& edge) {
  return {{-edge.to[0], edge.to[1]}, {-edge.from[0], edge.from[1]}, edge.bulge, edge.patch};
}

Edges images(const Edges& edges) {
  Edges all;
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) all.push_back(image(*edge));
  return all;
}

/// A loop whose points within `small` of the axis are on it.
Edges snapped(Edges loop, double small) {
  for (Edge& edge : loop)
    for (Vec<2>* end : {&edge.from, &edge.to}) {
      if ((*end)[0] < -small)
        throw BadParameters(fmt::format(
            "the tank's profile: the point at height {:.6g} m has the radius {:.6g} m; none may be negative", (*end)[1],
            (*end)[0]));
      if ((*end)[0] < small) (*end)[0] = 0;
    }
  return loop;
}

}  // namespace

Contour mirrored(const Contour& half) {
  const double small = 1e-9 * half.bounds().size().maxCoeff();
  std::vector<Edges> all;
  for (const Edges& given : half.loops()) {
    Edges loop = snapped(given, small);
    const auto on_axis = [](const Edge& edge) { return edge.from[0] == 0; };
    const auto first = std::find_if(loop.begin(), loop.end(), on_axis);
    if (first == loop.end()) {
      all.push_back(loop);
      all.push_back(images(loop));
      continue;
    }
    std::rotate(loop.begin(), first, loop.end());
    Edges chain;
    for (const Edge& edge : loop) {
      if (edge.from[0] == 0 && edge.to[0] == 0 && edge.bulge == 0) continue;
      chain.push_back(edge);
      if (edge.to[0] != 0) continue;
      const Edges other = images(chain);
      chain.insert(chain.end(), other.begin(), other.end());
      all.push_back(std::move(chain));
      chain.clear();
    }
  }
  return Contour(std::move(all));
}

}  // namespace seiche::solver
