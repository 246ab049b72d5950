#include "solver/tank/facets.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace seiche::solver {
namespace {

/// Where facets gather their points: patch and cube of l0 just inside the wall.
template <int D>
using Place = std::array<int, D + 1>;

template <int D>
struct Gathered {
  std::vector<Vec<D>> at, area;
};

template <int D>
class Gathering {
 public:
  Gathering(const Vec<D>& low, double l0) : low_(low), l0_(l0) {}

  /// A piece of the wall at `middle`, with the points of its quadrature, which stand for equal areas.
  void add(int patch, const Vec<D>& middle, const Vec<D>& area, const std::vector<Vec<D>>& points) {
    if (!(area.norm() > 0)) return;
    Place<D> place{patch};
    const Vec<D> inside = middle - 0.25 * l0_ * area.normalized();
    for (int a = 0; a < D; ++a) place[a + 1] = static_cast<int>(std::floor((inside[a] - low_[a]) / l0_));
    Gathered<D>& here = facing(area, pieces_[place]);
    for (const Vec<D>& point : points) {
      here.at.push_back(point);
      here.area.push_back(area / static_cast<double>(points.size()));
    }
  }

  std::vector<Facet<D>> facets() const {
    std::vector<Facet<D>> all;
    for (const auto& [place, pieces] : pieces_)
      for (const Gathered<D>& piece : pieces) all.push_back(facet_of(place[0], piece));
    return all;
  }

 private:
  /// Both sides of a plate may lie in one place.
  static Gathered<D>& facing(const Vec<D>& area, std::vector<Gathered<D>>& pieces) {
    for (Gathered<D>& piece : pieces)
      if (piece.area.front().dot(area) > -0.5 * piece.area.front().norm() * area.norm()) return piece;
    return pieces.emplace_back();
  }

  static Facet<D> facet_of(int patch, const Gathered<D>& piece) {
    Facet<D> facet;
    facet.patch = patch;
    double whole = 0;
    for (std::size_t k = 0; k < piece.at.size(); ++k) {
      facet.centre += piece.area[k].norm() * piece.at[k];
      whole += piece.area[k].norm();
    }
    facet.centre /= whole;
    for (std::size_t k = 0; k < piece.at.size(); ++k)
      facet.points.push_back({piece.at[k] - facet.centre, piece.area[k]});
    return facet;
  }

  Vec<D> low_;
  double l0_;
  std::map<Place<D>, std::vector<Gathered<D>>> pieces_;
};

void add_segment(int patch, const Vec<2>& from, const Vec<2>& to, double l0, Gathering<2>& all) {
  const Vec<2> way = to - from;
  const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / (0.5 * l0) - 1e-9)));
  const Vec<2> area = Vec<2>(way[1], -way[0]) / parts;
  const double gauss = 1 / std::sqrt(12);
  for (int k = 0; k < parts; ++k) {
    const auto at = [&](double share) { return Vec<2>(from + (k + share) / parts * way); };
    all.add(patch, at(0.5), area, {at(0.5 - gauss), at(0.5 + gauss)});
  }
}

using Polygon = std::vector<Vec<3>>;

/// What of a convex polygon has side * (x_axis - at) <= 0.
Polygon clipped(const Polygon& polygon, int axis, double at, double side) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<3>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double beyond_a = side * (a[axis] - at), beyond_b = side * (b[axis] - at);
    if (beyond_a <= 0) kept.push_back(a);
    if (beyond_a * beyond_b < 0) kept.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
  }
  return kept;
}

/// Cuts a convex polygon at every half spacing along `axis` and those after it; each piece has the midpoints of its
/// triangles' edges, which are exact for quadratics.
void add_polygon(int patch, const Polygon& polygon, int axis, const Vec<3>& low, double l0, Gathering<3>& all) {
  if (axis == 3) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const Vec<3>&a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
      all.add(patch, (a + b + c) / 3, 0.5 * (b - a).cross(c - a), {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)});
    }
    return;
  }
  const double h = 0.5 * l0, round_off = 1e-9;
  const auto cells = [&](const Vec<3>& r) { return (r[axis] - low[axis]) / h; };
  const auto less = [&](const Vec<3>& a, const Vec<3>& b) { return a[axis] < b[axis]; };
  const auto [lowest, highest] = std::minmax_element(polygon.begin(), polygon.end(), less);
  const int first = static_cast<int>(std::floor(cells(*lowest) + round_off));
  const int last = static_cast<int>(std::ceil(cells(*highest) - round_off)) - 1;
  Polygon rest = polygon;
  for (int k = first; k < last; ++k) {
    const double plane = low[axis] + (k + 1) * h;
    add_polygon(patch, clipped(rest, axis, plane, 1), axis + 1, low, l0, all);
    rest = clipped(rest, axis, plane, -1);
  }
  add_polygon(patch, rest, axis + 1, low, l0, all);
}

template <int D>
Vec<D> point_of(const SurfaceMesh& wall, int k) {
  return Vec<3>(wall.points[static_cast<std::size_t>(k)].data()).template head<D>();
}

}  // namespace

template <int D>
std::vector<Facet<D>> facets_of(const SurfaceMesh& wall, double l0) {
  const Vec<D> low = Vec<3>(wall.low().data()).template head<D>();
  Gathering<D> all(low, l0);
  for (std::size_t patch = 0; patch < wall.patches.size(); ++patch)
    for (const std::vector<int>& face : wall.patches[patch].faces) {
      const auto corner = [&](std::size_t k) { return point_of<D>(wall, face[k]); };
      if constexpr (D == 2)
        add_segment(static_cast<int>(patch), corner(0), corner(1), l0, all);
      else
        for (std::size_t k = 2; k < face.size(); ++k)
          add_polygon(static_cast<int>(patch), {corner(0), corner(k - 1), corner(k)}, 0, low, l0, all);
    }
  return all.facets();
}

template std::vector<Facet<2>> facets_of(const SurfaceMesh& wall, double l0);
template std::vector<Facet<3>> facets_of(const SurfaceMesh& wall, double l0);

}  // namespace seiche::solver
