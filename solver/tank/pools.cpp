#include "solver/tank/pools.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "solver/tank/level.hpp"

namespace seiche::solver {
namespace {

/// A cell as a key of maps.
template <int D>
std::array<int, D> key_of(const Eigen::Matrix<int, D, 1>& cell) {
  std::array<int, D> key;
  std::copy(cell.begin(), cell.end(), key.begin());
  return key;
}

/// The parts of a pool by their cells.
template <int D>
std::multimap<std::array<int, D>, std::size_t> by_cell(const Pool<D>& pool) {
  std::multimap<std::array<int, D>, std::size_t> parts;
  for (std::size_t k = 0; k < pool.parts.size(); ++k) parts.emplace(key_of<D>(pool.parts[k].cell), k);
  return parts;
}

/// Whether liquid at one point reaches another nearby without going through a wall or a baffle.
template <int D>
bool is_open_between(const Shape<D>& tank, const Baffles<D>* baffles, const Vec<D>& from, const Vec<D>& to) {
  return tank.nearest(0.5 * (from + to)).distance < 0 && (!baffles || baffles->sees(from, to));
}

/// None of what lies below a level: its lattice and the level alone.
template <int D>
Pool<D> empty_pool(const Parameters& p, const LevelAxes<D>& axes, const Bounds<D>& bounds, double level) {
  return {LiquidLattice<D>(bounds, level, p.particles.spacing, axes), level, 0, {}};
}

/// The same of a level above the lowest point of a tank whose liquid is at rest under gravity alone.
template <int D>
Pool<D> empty_pool(const Parameters& p, const Shape<D>& tank, double depth) {
  const LevelAxes<D> axes(p.gravity);
  const Bounds<D> bounds = axes.bounds_of(tank);
  return empty_pool(p, axes, bounds, bounds.low[1] + depth);
}

/// The cells below the level, without their volume.
template <int D>
Pool<D> filled(Pool<D> pool, const Parameters& p, const Shape<D>& tank) {
  const LevelAxes<D>& axes = pool.lattice.axes;
  const Bounds<D> bounds = axes.bounds_of(tank);
  const double end = p.fluid.column > 0 ? bounds.low[0] + p.fluid.column : bounds.high[0];
  const auto baffles = tank.baffles();
  pool.lattice.each([&](const auto& cell) {
    int number = 0;
    const Vec<D> centre = pool.lattice.centre(cell);
    for (const CellPart<D>& inside : parts_inside(tank, baffles.get(), centre, pool.lattice.l0, axes)) {
      if (inside.share == 0 || axes(inside.centroid)[0] > end) continue;
      pool.parts.push_back({cell, number, inside});
      ++number;
    }
  });
  return pool;
}

/// The pool about a point that holds a volume, by bisection of its level.
template <int D>
Pool<D> pool_holding(const Parameters& p, const Shape<D>& tank, const LevelAxes<D>& axes, const Vec<D>& point,
                     double volume) {
  const Bounds<D> bounds = axes.bounds_of(tank);
  double low = axes.height(point), high = bounds.high[1];
  Pool<D> pool = empty_pool(p, axes, bounds, high);
  while (high - low > 1e-4 * p.particles.spacing) {
    const double level = 0.5 * (low + high);
    pool = pool_about(filled(empty_pool(p, axes, bounds, level), p, tank), tank, point);
    (pool.volume < volume ? low : high) = level;
  }
  return pool;
}

}  // namespace

template <int D>
Pool<D> pool_below(const Parameters& p, const Shape<D>& tank, double depth) {
  Pool<D> pool = filled(empty_pool(p, tank, depth), p, tank);
  pool.volume = volume_below(on_level_axes(tank.surface(), p.gravity), pool.level);
  return pool;
}

template <int D>
Pool<D> pool_about(Pool<D> pool, const Shape<D>& tank, const Vec<D>& point) {
  using Cell = typename Pool<D>::Cell;
  const double l0 = pool.lattice.l0;
  const auto baffles = tank.baffles();
  const auto parts_at = by_cell(pool);
  std::vector<bool> joined(pool.parts.size(), false);
  std::vector<std::size_t> next;
  const auto join = [&](const Cell& cell, const Vec<D>& from) {
    for (auto [k, last] = parts_at.equal_range(key_of<D>(cell)); k != last; ++k) {
      if (joined[k->second]) continue;
      if (!is_open_between(tank, baffles.get(), from, pool.parts[k->second].inside.centroid)) continue;
      joined[k->second] = true;
      next.push_back(k->second);
    }
  };
  if (tank.nearest(point).distance < 0) join(pool.lattice.cell_at(point), point);
  while (!next.empty()) {
    const auto part = pool.parts[next.back()];
    next.pop_back();
    for (int a = 0; a < D; ++a)
      for (const int side : {-1, 1}) {
        Cell beside = part.cell;
        beside[a] += side;
        join(beside, part.inside.centroid);
      }
  }
  std::vector<typename Pool<D>::Part> parts;
  pool.volume = 0;
  for (std::size_t k = 0; k < pool.parts.size(); ++k) {
    if (!joined[k]) continue;
    parts.push_back(pool.parts[k]);
    pool.volume += pool.parts[k].inside.share * std::pow(l0, D);
  }
  pool.parts = std::move(parts);
  return pool;
}

template <int D>
std::vector<Pool<D>> pools_of(const Parameters& p, const Shape<D>& tank) {
  if (p.fluid.seeds.empty()) return {pool_below(p, tank, p.fluid.depth)};
  std::vector<Pool<D>> pools;
  for (const auto& seed : p.fluid.seeds)
    pools.push_back(pool_about(pool_below(p, tank, seed.depth), tank, point_of<D>(seed)));
  return pools;
}

template <int D>
std::vector<Pool<D>> pools_of(const Parameters& p, const Shape<D>& tank, const RelativeEquilibrium& at_rest) {
  if (at_rest == RelativeEquilibrium{p.gravity}) return pools_of(p, tank);
  const LevelAxes<D> axes(at_rest);
  std::vector<Pool<D>> pools;
  if (p.fluid.seeds.empty()) {
    const double volume = liquid_volume(p);
    const double level = level_holding(on_level_axes(tank.surface(), at_rest), volume);
    pools.push_back(filled(empty_pool(p, axes, axes.bounds_of(tank), level), p, tank));
    pools.back().volume = volume;
  }
  for (const auto& seed : p.fluid.seeds) {
    const Vec<D> point = point_of<D>(seed);
    const double volume = pool_about(pool_below(p, tank, seed.depth), tank, point).volume;
    pools.push_back(pool_holding(p, tank, axes, point, volume));
  }
  return pools;
}

template <int D>
std::vector<Pool<D>> levels_of(const Parameters& p, const Shape<D>& tank) {
  return p.fluid.seeds.empty() ? std::vector{empty_pool(p, tank, p.fluid.depth)} : pools_of(p, tank);
}

double liquid_volume(const Parameters& p) {
  if (p.fluid.seeds.empty()) {
    const SurfaceMesh wall = on_level_axes(wall_surface(p), p.gravity);
    return volume_below(wall, wall.low()[1] + p.fluid.depth);
  }
  const auto sum = [](const auto& pools) {
    double volume = 0;
    for (const auto& pool : pools) volume += pool.volume;
    return volume;
  };
  return p.dimension() == 3 ? sum(pools_of(p, *make_shape<3>(p))) : sum(pools_of(p, *make_shape<2>(p)));
}

template <int D>
bool meet(const Pool<D>& a, const Pool<D>& b, const Baffles<D>* baffles) {
  const auto parts_of_a = by_cell(a);
  for (const auto& part : b.parts) {
    const Vec<D>& r = part.inside.centroid;
    for (auto [k, last] = parts_of_a.equal_range(key_of<D>(a.lattice.cell_at(r))); k != last; ++k)
      if (!baffles || baffles->sees(r, a.parts[k->second].inside.centroid)) return true;
  }
  return false;
}

template <int D>
double level_beside(const std::vector<Pool<D>>& pools, const Vec<D>& r) {
  double level = pools.front().level, nearest = std::numeric_limits<double>::infinity();
  if (pools.size() == 1) return level;
  for (const Pool<D>& pool : pools)
    for (const auto& part : pool.parts) {
      const Vec<D> offset = pool.lattice.axes(part.inside.centroid - r);
      const double aside = std::max(0.0, std::hypot(offset[0], D == 3 ? offset[D - 1] : 0.0) - 0.5 * pool.lattice.l0);
      const double distance = aside + 1e-3 * std::abs(offset[1]);
      if (distance < nearest) nearest = distance, level = pool.level;
    }
  return level;
}

template Pool<2> pool_below(const Parameters&, const Shape<2>&, double);
template Pool<2> pool_about(Pool<2>, const Shape<2>&, const Vec<2>&);
template std::vector<Pool<2>> pools_of(const Parameters&, const Shape<2>&);
template std::vector<Pool<2>> pools_of(const Parameters&, const Shape<2>&, const RelativeEquilibrium&);
template std::vector<Pool<2>> levels_of(const Parameters&, const Shape<2>&);
template bool meet(const Pool<2>&, const Pool<2>&, const Baffles<2>*);
template double level_beside(const std::vector<Pool<2>>&, const Vec<2>&);
template Pool<3> pool_below(const Parameters&, const Shape<3>&, double);
template Pool<3> pool_about(Pool<3>, const Shape<3>&, const Vec<3>&);
template std::vector<Pool<3>> pools_of(const Parameters&, const Shape<3>&);
template std::vector<Pool<3>> pools_of(const Parameters&, const Shape<3>&, const RelativeEquilibrium&);
template std::vector<Pool<3>> levels_of(const Parameters&, const Shape<3>&);
template bool meet(const Pool<3>&, const Pool<3>&, const Baffles<3>*);
template double level_beside(const std::vector<Pool<3>>&, const Vec<3>&);

}  // namespace seiche::solver
