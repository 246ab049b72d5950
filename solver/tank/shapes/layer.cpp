#include "solver/tank/shapes/layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/tank/shapes/offset.hpp"

namespace seiche::solver {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
/// Turn of a corner that has a point of its own [rad].
constexpr double least_turn = 0.5;
/// Corners that are nearer to each other share one point [l0].
constexpr double least_gap = 0.7;

/// A place on a path that has a point.
struct Node {
  double at;    ///< [m] along it
  double turn;  ///< endless at an end
  bool half;    ///< an end on the axis: the point is half a spacing from it
};

struct Ends {
  bool first_on_axis, last_on_axis;
};

std::vector<Node> nodes_of(const Path& path, const Along& along, Ends ends) {
  std::vector<Node> nodes;
  if (!path.closed) nodes.push_back({0, endless, ends.first_on_axis});
  for (std::size_t k = path.closed ? 0 : 1; k < path.edges.size(); ++k) {
    const Edge& before = path.edges[k > 0 ? k - 1 : path.edges.size() - 1];
    const double turn = std::abs(turn_between(before, path.edges[k]));
    if (turn >= least_turn) nodes.push_back({along.begin(k), turn, false});
  }
  if (!path.closed) nodes.push_back({along.length(), endless, ends.last_on_axis});
  return nodes;
}

/// Leaves out the less sharp of corners that are too near to each other.
void thin_out(std::vector<Node>& nodes, bool closed, double length, double gap) {
  while (nodes.size() > 1) {
    const std::size_t pairs = closed ? nodes.size() : nodes.size() - 1;
    std::size_t shortest = 0;
    double least = endless;
    for (std::size_t k = 0; k < pairs; ++k) {
      const Node &a = nodes[k], &b = nodes[(k + 1) % nodes.size()];
      double between = b.at - a.at;
      if (between <= 0) between += length;
      if (a.half != b.half) between += 0.5 * gap;
      if (between < least) least = between, shortest = k;
    }
    if (least >= gap) return;
    const std::size_t other = (shortest + 1) % nodes.size();
    const std::size_t out = nodes[other].turn < nodes[shortest].turn ? other : shortest;
    if (nodes[out].turn == endless) return;
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(out));
  }
}

/// Places of the points between two nodes, the first node's with them, the second's not.
void add_places(const Node& a, const Node& b, double length, double l0, std::vector<double>& places) {
  const double halves = 0.5 * (a.half + b.half);
  const double count = std::max(1.0, std::round(length / l0 + (halves == 0.5 ? 0.5 : 0)));
  const double spacing = length / (count - (halves == 0.5 ? 0.5 : 0));
  if (!a.half) places.push_back(a.at);
  const double first = a.half ? 0.5 : 1;
  for (double k = first; k < length / spacing - 0.25; ++k) places.push_back(a.at + k * spacing);
}

std::vector<double> places_of(const Path& path, const Along& along, double l0, Ends ends) {
  std::vector<Node> nodes = nodes_of(path, along, ends);
  const double length = along.length();
  thin_out(nodes, path.closed, length, least_gap * l0);
  if (nodes.empty()) nodes.push_back({0, 0, false});
  std::vector<double> places;
  if (!path.closed && !ends.first_on_axis && !ends.last_on_axis && nodes.size() == 2 && length < least_gap * l0)
    return {0.5 * length};
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    add_places(nodes[k], nodes[k + 1], nodes[k + 1].at - nodes[k].at, l0, places);
  if (path.closed)
    add_places(nodes.back(), nodes.front(), nodes.front().at + length - nodes.back().at, l0, places);
  else if (!nodes.back().half)
    places.push_back(length);
  return places;
}

/// How much of its piece the point of a layer stands for: less or more than 1 in a solid whose other side is near.
double share_of(const Contour& wall, const Vec<2>& r, int layer, bool last, double l0) {
  const Nearest<2> near = wall.nearest(r);
  if ((r - near.foot - near.distance * near.normal).norm() > 1e-6 * l0) return 1;
  const double depth = (layer + 1.5) * l0;
  const Nearest<2> behind = wall.nearest(near.foot + depth * near.normal);
  if (behind.distance > depth - 1e-6 * l0 || behind.normal.dot(near.normal) > -0.7) return 1;
  const double middle = 0.5 * (depth + behind.distance) / l0;
  if (middle < 1) return 1;
  return last ? std::min(1.0, middle - layer) : middle - layer;
}

/// Ends of two paths that meet, as behind a sharp edge of the solid, become one point.
void merge_ends(std::vector<LayerPoint>& points, std::vector<std::size_t> ends, double gap) {
  std::vector<std::size_t> out;
  for (std::size_t a = 0; a < ends.size(); ++a)
    for (std::size_t b = a + 1; b < ends.size(); ++b) {
      LayerPoint &kept = points[ends[a]], &merged = points[ends[b]];
      if (merged.length == 0 || kept.length == 0 || (kept.position - merged.position).norm() > gap) continue;
      const double length = kept.length + merged.length;
      kept.position = (kept.length * kept.position + merged.length * merged.position) / length;
      kept.length = length;
      kept.moment += merged.moment;
      merged.length = 0;
    }
  std::erase_if(points, [](const LayerPoint& point) { return point.length == 0; });
}

}  // namespace

std::vector<LayerPoint> layer_points(const Contour& wall, int layer, bool last, double l0, bool right_half) {
  std::vector<LayerPoint> points;
  std::vector<std::size_t> ends;
  for (const Path& path : offset_wall(wall, (layer + 0.5) * l0, right_half)) {
    const Along along(path);
    const auto on_axis = [&](const Vec<2>& r) { return right_half && !path.closed && r[0] < 1e-6 * l0; };
    const Ends axis{on_axis(path.edges.front().from), on_axis(path.edges.back().to)};
    const std::vector<double> places = places_of(path, along, l0, axis);
    const std::size_t count = places.size();
    for (std::size_t k = 0; k < count; ++k) {
      const double at = places[k];
      double from = k > 0 ? 0.5 * (places[k - 1] + at) : 0,
             to = k + 1 < count ? 0.5 * (at + places[k + 1]) : along.length();
      if (path.closed && k == 0) from = 0.5 * (places.back() - along.length() + at);
      if (path.closed && k + 1 == count) to = 0.5 * (at + places.front() + along.length());
      const Vec<2> r = along.point(at);
      const double share = share_of(wall, r, layer, last, l0);
      if (!path.closed && ((k == 0 && !axis.first_on_axis) || (k + 1 == count && !axis.last_on_axis)))
        ends.push_back(points.size());
      points.push_back({r, share * (to - from), share * (along.moment(to) - along.moment(from))});
    }
  }
  merge_ends(points, ends, 0.3 * l0);
  return points;
}

}  // namespace seiche::solver
