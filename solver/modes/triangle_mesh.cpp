#include "solver/modes/triangle_mesh.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "solver/tank/edge.hpp"

namespace seiche::solver::modes {

TriangleMesh::TriangleMesh(std::vector<Vec<2>> points, const std::vector<std::array<int, 3>>& triangles,
                           const std::vector<bool>& surface_from)
    : points_(std::move(points)) {
  std::map<std::pair<int, int>, int> sides;  // triangle on the left of the way from a to b
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sides[{triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]}] = static_cast<int>(t);
  for (const auto& corners : triangles) {
    Triangle triangle{corners, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const auto beyond = sides.find({b, a});
      triangle.across[k] =
          beyond != sides.end() ? beyond->second : (surface_from[static_cast<std::size_t>(a)] ? surface : wall);
    }
    triangles_.push_back(triangle);
  }
  std::vector<int> all(triangles_.size());
  std::iota(all.begin(), all.end(), 0);
  make_delaunay(std::move(all));
}

int TriangleMesh::shared(int t, int neighbour) const {
  const auto& across = at(t).across;
  return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
}

void TriangleMesh::place(const Vec<2>& origin, double unit) {
  for (Vec<2>& point : points_) point = origin + unit * point;
}

int TriangleMesh::add(const Triangle& triangle) {
  triangles_.push_back(triangle);
  return static_cast<int>(triangles_.size()) - 1;
}

void TriangleMesh::link(int t, int from, int to) {
  if (t >= 0) at(t).across[turned(shared(t, from))] = to;
}

bool TriangleMesh::should_flip(int t, int k) const {
  const int n = at(t).across[turned(k)];
  if (n < 0) return false;
  const int m = shared(n, t);
  const Vec<2>&c = corner(t, k), &a = corner(t, k + 1), &b = corner(t, k + 2), &d = corner(n, m);
  // The angles at c and d are more than 180 degrees together.
  const Vec<2> ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double sine = cross(ca, cb) * da.dot(db) - cross(da, db) * ca.dot(cb);
  constexpr double tolerance = 1e-10;
  if (sine * std::abs(sine) >=
      -tolerance * tolerance * ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm())
    return false;
  return cross(ca, d - c) > 0 && cross(d - c, cb) > 0;
}

void TriangleMesh::flip(int t, int k) {
  const int n = at(t).across[turned(k)], m = shared(n, t);
  const auto [c, a, b] =
      std::array{at(t).corners[turned(k)], at(t).corners[turned(k + 1)], at(t).corners[turned(k + 2)]};
  const int d = at(n).corners[turned(m)];
  const int across_bc = at(t).across[turned(k + 1)], across_ca = at(t).across[turned(k + 2)];
  const int across_ad = at(n).across[turned(m + 1)], across_db = at(n).across[turned(m + 2)];
  at(t) = {{c, a, d}, {across_ad, n, across_ca}};
  at(n) = {{c, d, b}, {across_db, across_bc, t}};
  link(across_ad, n, t);
  link(across_bc, t, n);
}

void TriangleMesh::make_delaunay(std::vector<int> changed) {
  while (!changed.empty()) {
    const int t = changed.back();
    changed.pop_back();
    for (int k = 0; k < 3; ++k)
      if (should_flip(t, k)) {
        changed.push_back(at(t).across[turned(k)]);
        changed.push_back(t);
        flip(t, k);
        break;
      }
  }
}

void TriangleMesh::split(int t, int k) {
  const int n = at(t).across[turned(k)];
  const auto [c, a, b] =
      std::array{at(t).corners[turned(k)], at(t).corners[turned(k + 1)], at(t).corners[turned(k + 2)]};
  const int across_bc = at(t).across[turned(k + 1)], across_ca = at(t).across[turned(k + 2)];
  const int middle = static_cast<int>(points_.size());
  points_.push_back(0.5 * (corner(t, k + 1) + corner(t, k + 2)));
  const int u = add({{c, middle, b}, {n, across_bc, t}});
  at(t) = {{c, a, middle}, {n, u, across_ca}};
  link(across_bc, t, u);
  std::vector<int> changed{t, u};
  if (n >= 0) {
    const int m = shared(n, t);
    const int d = at(n).corners[turned(m)];
    const int across_ad = at(n).across[turned(m + 1)], across_db = at(n).across[turned(m + 2)];
    const int v = add({{d, b, middle}, {u, n, across_db}});
    at(n) = {{d, middle, a}, {t, across_ad, v}};
    link(across_db, n, v);
    at(u).across[0] = v;
    changed.push_back(n);
    changed.push_back(v);
  }
  make_delaunay(std::move(changed));
}

}  // namespace seiche::solver::modes
