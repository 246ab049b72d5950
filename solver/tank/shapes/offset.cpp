#include "solver/tank/shapes/offset.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

using Edges = std::vector<Edge>;

/// A mitre is 1/cos(turn/2) as far from the corner as its layer from the wall.
constexpr double longest_mitre = 1.5;
/// Edges that meet at less turn than this go on smoothly [rad].
constexpr double smooth = 1e-9;

/// All edges at a distance behind a loop's, with what joins them at corners of the tank.
Edges moved(const Edges& loop, double distance) {
  Edges all;
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Edge &edge = loop[k], &before = loop[(k + count - 1) % count], &after = loop[(k + 1) % count];
    const Vec<2> n0 = edge.normal(0), n1 = edge.normal(1);
    Edge shifted{edge.from + distance * n0, edge.to + distance * n1, edge.bulge, edge.patch};
    const auto mitre = [&](const Edge& first, const Edge& second, Vec<2>& tip) {
      const double turn = turn_between(first, second);
      if (turn < smooth || longest_mitre * std::cos(0.5 * turn) < 1) return false;
      const Vec<2> a = first.normal(1), b = second.normal(0);
      tip = first.to + distance * (a + b) / (1 + a.dot(b));
      return true;
    };
    Vec<2> tip = Vec<2>::Zero();
    const bool is_arc = edge.bulge != 0;
    if (mitre(before, edge, tip)) {
      if (is_arc)
        all.push_back({tip, shifted.from, 0, edge.patch});
      else
        shifted.from = tip;
    }
    const bool has_end = mitre(edge, after, tip);
    if (has_end && !is_arc) shifted.to = tip;
    // An arc about a centre in the solid ends where the curve comes to the centre.
    if (edge.bulge >= 0 || distance < edge.radius() * (1 - 1e-9)) all.push_back(shifted);
    if (has_end && is_arc) all.push_back({shifted.to, tip, 0, edge.patch});
    if (const double turn = turn_between(edge, after); turn > smooth && !has_end)
      all.push_back({shifted.to, edge.to + distance * after.normal(0), std::tan(0.25 * turn), edge.patch});
  }
  return all;
}

}  // namespace

std::vector<Path> offset_wall(const Contour& wall, double distance, bool right_half) {
  const auto kept = [&](const Vec<2>& r) {
    return (!right_half || r[0] >= 0) && wall.nearest(r).distance >= distance * (1 - 1e-9);
  };
  std::vector<Path> all;
  for (const Edges& loop : wall.loops()) {
    Edges edges;
    for (const Edge& edge : moved(loop, distance))
      if (edge.length() > 1e-9 * distance) add_kept(edge, kept, 0.125 * distance, edges);
    std::erase_if(edges, [&](const Edge& edge) { return edge.length() < 1e-9 * distance; });
    for (Path& path : joined(edges, 1e-4 * distance)) all.push_back(std::move(path));
  }
  return all;
}

}  // namespace seiche::solver
