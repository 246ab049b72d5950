#include "solver/tank/shapes/path.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

/// Integral of x over the first s of the edge's length.
double moment_of(const Edge& edge, double s) {
  const double whole = edge.length();
  if (edge.bulge == 0) return edge.from[0] * s + 0.5 * s * s / whole * (edge.to[0] - edge.from[0]);
  const Vec<2> centre = edge.centre(), from = edge.from - centre, to = edge.point(s / whole) - centre;
  // x = c + R cos(a) with ds = R |da|: the integral of R cos is R (R sin), signed.
  return centre[0] * s + (edge.bulge > 0 ? 1 : -1) * edge.radius() * (to[1] - from[1]);
}

}  // namespace

Along::Along(const Path& path) : path_(path), begin_{0}, moment_{0} {
  for (const Edge& edge : path.edges) {
    begin_.push_back(begin_.back() + edge.length());
    moment_.push_back(moment_.back() + moment_of(edge, edge.length()));
  }
}

std::size_t Along::edge_at(double s) const {
  const auto after = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, s);
  return static_cast<std::size_t>(after - begin_.begin() - 1);
}

Vec<2> Along::point(double s) const {
  if (path_.closed) s -= std::floor(s / length()) * length();
  const std::size_t k = edge_at(s);
  return path_.edges[k].point((s - begin_[k]) / path_.edges[k].length());
}

double Along::moment(double s) const {
  double rounds = 0;
  if (path_.closed) {
    rounds = std::floor(s / length());
    s -= rounds * length();
  }
  const std::size_t k = edge_at(s);
  return rounds * moment_.back() + moment_[k] + moment_of(path_.edges[k], s - begin_[k]);
}

Edge piece(const Edge& edge, double from, double to) {
  if (from == 0 && to == 1) return edge;
  return {edge.point(from), edge.point(to), edge.bulge == 0 ? 0 : std::tan(0.25 * edge.angle() * (to - from)),
          edge.patch};
}

double turn_between(const Edge& before, const Edge& after) {
  const Vec<2> a = before.normal(1), b = after.normal(0);
  return std::atan2(cross(a, b), a.dot(b));
}

void add_kept(const Edge& edge, const std::function<bool(const Vec<2>&)>& kept, double step, std::vector<Edge>& all) {
  const int count = std::max(2, static_cast<int>(std::ceil(edge.length() / step)));
  double begin = -1, last = 0;
  bool was = kept(edge.point(0));
  if (was) begin = 0;
  for (int k = 1; k <= count; ++k) {
    const double share = double(k) / count;
    const bool is = kept(edge.point(share));
    if (is != was) {
      double on = is ? share : last, off = is ? last : share;
      while (std::abs(on - off) > 1e-15) {
        const double middle = 0.5 * (on + off);
        if (middle == on || middle == off) break;
        (kept(edge.point(middle)) ? on : off) = middle;
      }
      if (is)
        begin = on;
      else if (on > begin)
        all.push_back(piece(edge, begin, on));
    }
    was = is, last = share;
  }
  if (was) all.push_back(piece(edge, begin, 1));
}

std::vector<Path> joined(const std::vector<Edge>& edges, double tolerance) {
  std::vector<Path> paths;
  const auto follows = [&](const Edge& a, const Edge& b) { return (a.to - b.from).norm() < tolerance; };
  for (const Edge& edge : edges) {
    if (paths.empty() || !follows(paths.back().edges.back(), edge)) paths.push_back({{}, false});
    paths.back().edges.push_back(edge);
  }
  if (paths.empty() || !follows(paths.back().edges.back(), paths.front().edges.front())) return paths;
  if (paths.size() == 1) {
    paths[0].closed = true;
  } else {
    std::vector<Edge>& last = paths.back().edges;
    last.insert(last.end(), paths.front().edges.begin(), paths.front().edges.end());
    paths.erase(paths.begin());
  }
  return paths;
}

}  // namespace seiche::solver
