#include "solver/tank/mesh/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>

namespace seiche::solver {
namespace {

constexpr double merging_distance = 1e-7;  // of the mesh's size

/// Numbers of points, by place: those nearer to each other than a distance have one.
class Places {
 public:
  Places(Vecs<3>& points, const Vec<3>& low, double distance) : points_(points), low_(low), distance_(distance) {}

  int of(const Vec<3>& r) {
    const auto from = cell(r - Vec<3>::Constant(distance_)), to = cell(r + Vec<3>::Constant(distance_));
    for (auto x = from[0]; x <= to[0]; ++x)
      for (auto y = from[1]; y <= to[1]; ++y)
        for (auto z = from[2]; z <= to[2]; ++z) {
          const auto [first, last] = cells_.equal_range(key({x, y, z}));
          for (auto at = first; at != last; ++at)
            if ((points_[at->second] - r).norm() <= distance_) return at->second;
        }
    const int place = static_cast<int>(points_.size());
    points_.push_back(r);
    cells_.emplace(key(cell(r)), place);
    return place;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell(const Vec<3>& r) const {
    Cell c;
    // So wide that a point is seldom near a side of its cell.
    for (int a = 0; a < 3; ++a) c[a] = static_cast<std::int64_t>(std::floor((r[a] - low_[a]) / (16 * distance_)));
    return c;
  }
  static std::uint64_t key(const Cell& c) {
    std::uint64_t hash = 0;
    for (const std::int64_t x : c) hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
    return hash;
  }

  Vecs<3>& points_;
  Vec<3> low_;
  double distance_;
  std::unordered_multimap<std::uint64_t, int> cells_;
};

}  // namespace

Vec<3> Triangles::centre(int triangle) const {
  return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
}

Vec<3> Triangles::area(int triangle) const {
  const Vec<3>& a = corner(triangle, 0);
  return 0.5 * cross(corner(triangle, 1) - a, corner(triangle, 2) - a);
}

Bounds<3> Triangles::box(int triangle) const {
  const Vec<3>&a = corner(triangle, 0), &b = corner(triangle, 1), &c = corner(triangle, 2);
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

Bounds<3> Triangles::bounds() const {
  Bounds<3> all = box(0);
  for (int k = 1; k < count(); ++k) {
    const Bounds<3> one = box(k);
    all.low = all.low.cwiseMin(one.low);
    all.high = all.high.cwiseMax(one.high);
  }
  return all;
}

void Triangles::add(const std::array<int, 3>& at, int of_patch) {
  corners.push_back(at);
  patch.push_back(of_patch);
}

Triangles triangles_of(const SurfaceMesh& mesh, LeftOut& left_out) {
  Triangles triangles;
  const Vec<3> low(mesh.low().data()), size(mesh.size().data());
  Places places(triangles.points, low, std::max(merging_distance * size.norm(), 1e-300));
  std::vector<int> place;
  for (const auto& point : mesh.points) place.push_back(places.of(Vec<3>(point.data())));
  std::set<std::array<int, 3>> known;
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
    for (const auto& face : mesh.patches[patch].faces)
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        const std::array<int, 3> corners{place[face[0]], place[face[k]], place[face[k + 1]]};
        std::array<int, 3> sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] == sorted[1] || sorted[1] == sorted[2])
          ++left_out.degenerate;
        else if (!known.insert(sorted).second)
          ++left_out.doubles;
        else
          triangles.add(corners, static_cast<int>(patch));
      }
  return triangles;
}

}  // namespace seiche::solver
