#include "solver/tank/box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/tank/check_whole.hpp"

namespace seiche::solver {
namespace {

struct Wall {
  const char* name;
  int axis;
  bool high;
};

template <int D>
constexpr auto walls_of() {
  if constexpr (D == 2)
    return std::array{Wall{"left", 0, false}, Wall{"right", 0, true}, Wall{"floor", 1, false}, Wall{"roof", 1, true}};
  else
    return std::array{Wall{"left", 0, false}, Wall{"right", 0, true},  Wall{"near", 2, false},
                      Wall{"far", 2, true},   Wall{"floor", 1, false}, Wall{"roof", 1, true}};
}

template <int D>
constexpr auto walls = walls_of<D>();

}  // namespace

template <int D>
Box<D>::Box(const Parameters& p) : closed_(p.tank.closed) {
  size_[0] = p.tank.length;
  size_[1] = p.tank.height;
  if constexpr (D == 3) size_[2] = p.tank.width;
}

template <int D>
Nearest<D> Box<D>::nearest(const Vec<D>& r) const {
  // Outside, the foot is the nearest point of the box; inside, the projection on the nearest wall. Its wall is the one
  // that r is farthest beyond, or least short of.
  Nearest<D> result;
  double farthest = -std::numeric_limits<double>::infinity();
  result.foot = r;
  for (int k = 0; k < static_cast<int>(walls<D>.size()); ++k) {
    const auto [wall, axis, high] = walls<D>[k];
    if (axis == 1 && high && !closed_) continue;
    const double beyond = high ? r[axis] - size_[axis] : -r[axis];
    if (beyond > 0) result.foot[axis] = high ? size_[axis] : 0;
    if (beyond > farthest) farthest = beyond, result.patch = k;
  }
  const auto [wall, axis, high] = walls<D>[result.patch];
  result.normal[axis] = high ? 1 : -1;
  if (farthest > 0) {
    result.distance = (r - result.foot).norm();
  } else {
    result.foot[axis] = high ? size_[axis] : 0;
    result.distance = farthest;
  }
  return result;
}

template <>
SurfaceMesh Box<2>::surface() const {
  const double x = size_[0], y = size_[1];
  SurfaceMesh mesh{{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}},
                   {{"left", {{3, 0}}}, {"right", {{1, 2}}}, {"floor", {{0, 1}}}, {"roof", {{2, 3}}}}};
  if (!closed_) mesh.patches.pop_back();
  return mesh;
}

template <>
SurfaceMesh Box<3>::surface() const {
  SurfaceMesh mesh;
  // A corner's number has a bit for each axis on which it is at the high end.
  for (int corner = 0; corner < 8; ++corner)
    mesh.points.push_back({corner & 1 ? size_[0] : 0, corner & 2 ? size_[1] : 0, corner & 4 ? size_[2] : 0});
  mesh.patches = {{"left", {{0, 4, 6, 2}}}, {"right", {{1, 3, 7, 5}}}, {"near", {{0, 2, 3, 1}}},
                  {"far", {{4, 5, 7, 6}}},  {"floor", {{0, 1, 5, 4}}}, {"roof", {{2, 6, 7, 3}}}};
  if (!closed_) mesh.patches.pop_back();
  return mesh;
}

template <int D>
std::vector<WallPoint<D>> Box<D>::wall_points(int layers, double l0, double) const {
  using Cell = Eigen::Matrix<int, D, 1>;
  const Cell first = Cell::Constant(-layers), cells = (size_.array() / l0).round().template cast<int>();
  Cell last = cells.array() + layers;
  if (!closed_) last[1] -= layers;
  std::vector<WallPoint<D>> points;
  for (Cell c = first; c[D - 1] < last[D - 1];) {
    const int beyond = std::max((-1 - c.array()).maxCoeff(), (c - cells).maxCoeff());
    if (beyond >= 0) {
      const Vec<D> r = (c.template cast<double>().array() + 0.5) * l0;
      const Nearest<D> wall = nearest(r);
      const bool beyond_edge = (r - wall.foot - wall.distance * wall.normal).norm() > 1e-6 * l0;
      points.push_back({r, beyond_edge ? Vec<D>(Vec<D>::Zero()) : wall.normal, 1, beyond, wall.patch, {}});
    }
    for (int a = 0; ++c[a] == last[a] && a < D - 1; ++a) c[a] = first[a];
  }
  return points;
}

template <int D>
std::string Box<D>::description() const {
  return fmt::format("x from 0 to {:.6g} m, y from 0 to {:.6g} m", size_[0], size_[1]) +
         (D == 3 ? fmt::format(", z from 0 to {:.6g} m", size_[D - 1]) : ", and has no z");
}

template class Box<2>;
template class Box<3>;

bool fits_lattice(const Parameters& p) {
  const auto fits = [&](double length) { return is_whole(length, p.particles.spacing); };
  return fits(p.tank.length) && fits(p.tank.height) && fits(p.tank.width);
}

void check_box(const Parameters& p) {
  check_whole("tank.length", p.tank.length, p.particles.spacing);
  check_whole("tank.height", p.tank.height, p.particles.spacing);
  if (p.tank.width > 0) check_whole("tank.width", p.tank.width, p.particles.spacing);
}

}  // namespace seiche::solver
