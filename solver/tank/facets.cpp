#include "solver/tank/facets.hpp"

#include <Eigen/Geometry>
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
    Gathered<D>& here = pieces_[place];
    for (const Vec<D>& point : points) {
      here.at.push_back(point);
      here.area.push_back(area / static_cast<double>(points.size()));
    }
  }

  std::vector<Facet<D>> facets() const {
    std::vector<Facet<D>> all;
    for (const auto& [place, piece] : pieces_) {
      Facet<D> facet;
      double whole = 0;
      for (std::size_t k = 0; k < piece.at.size(); ++k) {
        facet.centre += piece.area[k].norm() * piece.at[k];
        whole += piece.area[k].norm();
      }
      facet.centre /= whole;
      for (std::size_t k = 0; k < piece.at.size(); ++k)
        facet.points.push_back({piece.at[k] - facet.centre, piece.area[k]});
      all.push_back(std::move(facet));
    }
    return all;
  }

 private:
  Vec<D> low_;
  double l0_;
  std::map<Place<D>, Gathered<D>> pieces_;
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

void add_triangle(int patch, const std::array<Vec<3>, 3>& corner, double l0, Gathering<3>& all) {
  int longest = 0;
  double length = 0;
  for (int k = 0; k < 3; ++k)
    if (const double side = (corner[(k + 1) % 3] - corner[k]).norm(); side > length) length = side, longest = k;
  const Vec<3>&a = corner[longest], &b = corner[(longest + 1) % 3], &c = corner[(longest + 2) % 3];
  if (length > 0.5 * l0 * (1 + 1e-9)) {
    const Vec<3> middle = 0.5 * (a + b);
    add_triangle(patch, {a, middle, c}, l0, all);
    add_triangle(patch, {middle, b, c}, l0, all);
    return;
  }
  all.add(patch, (a + b + c) / 3, 0.5 * (b - a).cross(c - a), {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)});
}

template <int D>
Vec<D> point_of(const SurfaceMesh& wall, int k) {
  return Vec<3>(wall.points[static_cast<std::size_t>(k)].data()).template head<D>();
}

}  // namespace

template <int D>
std::vector<Facet<D>> facets_of(const SurfaceMesh& wall, double l0) {
  Gathering<D> all(Vec<3>(wall.low().data()).template head<D>(), l0);
  for (std::size_t patch = 0; patch < wall.patches.size(); ++patch)
    for (const std::vector<int>& face : wall.patches[patch].faces) {
      const auto corner = [&](std::size_t k) { return point_of<D>(wall, face[k]); };
      if constexpr (D == 2)
        add_segment(static_cast<int>(patch), corner(0), corner(1), l0, all);
      else
        for (std::size_t k = 2; k < face.size(); ++k)
          add_triangle(static_cast<int>(patch), {corner(0), corner(k - 1), corner(k)}, l0, all);
    }
  return all.facets();
}

template std::vector<Facet<2>> facets_of(const SurfaceMesh& wall, double l0);
template std::vector<Facet<3>> facets_of(const SurfaceMesh& wall, double l0);

}  // namespace seiche::solver
