#include "solver/sensors/surface_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace seiche::solver {
namespace {

/// Less of a place than that is left by the walls: it lies behind them.
constexpr double least_open = 0.25;

}  // namespace

template <int D>
LiquidLattice<D> lattice_of_columns(const Shape<D>& tank, const Gravity& gravity, double l0) {
  const LevelAxes<D> axes(gravity);
  const Bounds<D> bounds = axes.bounds_of(tank);
  return {bounds, bounds.high[1], l0, axes};
}

template <int D>
SurfaceProfile<D>::SurfaceProfile(const Shape<D>& tank, const Gravity& gravity, double l0, const State<D>& walls)
    : lattice_(lattice_of_columns(tank, gravity, l0)),
      closed_(tank.is_closed()),
      beside_(lattice_),
      mirrored_(lattice_),
      water_(lattice_) {
  columns_.resize(static_cast<std::size_t>(count(0)) * count(1));
  height_.resize(columns_.size());
  gas_.resize(columns_.size());
  for (Column& column : columns_) column.below.assign(1, 0);
  lattice_.each([&](const Cell& cell) { columns_[number(cell)].add_cell(lattice_.part_inside(tank, cell).share); });
  add_walls(tank, walls);
}

template <int D>
void SurfaceProfile<D>::find(const State<D>& s, const FluidCells<D>& cells) {
  sort(s, cells);
  fill_mirrors();
  const int columns = static_cast<int>(height_.size());
#pragma omp parallel for schedule(static)
  for (int c = 0; c < columns; ++c) {
    height_[c] = crossing(c);
    gas_[c] = gas_below(c);
  }
}

template <int D>
double SurfaceProfile<D>::fraction(const Vec<D>& r) const {
  const Vec<D> at = lattice_.axes(r);
  const double open = 1 - beside_.sum(at);
  return open < least_open ? 0 : (water_.sum(at) + mirrored_.sum(at)) / open;
}

template <int D>
double SurfaceProfile<D>::volume() const {
  double cells = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    cells += columns_[c].cells_below((height_[c] - lattice_.corner[1]) / lattice_.l0, closed_);
  const double gas = std::accumulate(gas_.begin(), gas_.end(), 0.0);
  return gas > 0.01 * cells ? std::numeric_limits<double>::quiet_NaN() : cells * std::pow(lattice_.l0, D);
}

template <int D>
void SurfaceProfile<D>::add_walls(const Shape<D>& tank, const State<D>& walls) {
  LatticeColumns<D> all(lattice_);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls.kind[i] == Kind::fluid) continue;
    const Vec<D>& r = walls.position[i];
    const Vec<D> at = lattice_.axes(r);
    if (walls.behind[i] >= 0) {
      const double solid = walls.volume[i] * share_in_baffle(tank, walls.baffles->faces()[walls.behind[i]], r);
      all.add(at, solid);
      beside_.add(at, solid);
      continue;
    }
    const double upright = std::pow(lattice_.axes.height((r - tank.nearest(r).foot).normalized()), 2);
    all.add(at, walls.volume[i]);
    if (upright < 1) beside_.add(at, (1 - upright) * walls.volume[i]);
    if (upright > 1e-12) mirrored_.add(at, upright * walls.volume[i]);
  }
  all.sort();
  beside_.sort();
  mirrored_.sort();
  for (std::size_t i = 0; i < mirrored_.size(); ++i) {
    const Vec<D> r = lattice_.axes.in_tank(mirrored_.position(i));
    const Nearest<D> wall = tank.nearest(r);
    Vec<D> point = 2 * wall.foot - r;
    if (tank.nearest(point).distance > 0) point = wall.foot - 0.5 * lattice_.l0 * wall.normal;
    point = lattice_.axes(point);
    mirrors_.push_back({point, mirrored_.weight(i) / std::max(least_open, 1 - all.linear_sum(point))});
  }
}

template <int D>
double SurfaceProfile<D>::share_in_baffle(const Shape<D>& tank, const BaffleFace<D>& face, const Vec<D>& r) const {
  const double depth = face.behind(r), l0 = lattice_.l0, step = 0.02 * l0;
  const Vec<D> normal = face.normal_at(r), foot = face.foot(r);
  if (!face.holds(foot) || tank.nearest(foot - step * normal).distance > 0) return 0;
  double half = 0;
  while (half < depth + l0 && tank.nearest(foot + 2 * (half + step) * normal).distance > 0) half += step;
  return std::clamp((half - depth) / l0 + 0.5, 0.0, 1.0);
}

template <int D>
void SurfaceProfile<D>::fill_mirrors() {
  const int size = static_cast<int>(mirrors_.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) mirrored_.set_weight(i, mirrors_[i].weight * water_.linear_sum(mirrors_[i].point));
}

template <int D>
void SurfaceProfile<D>::sort(const State<D>& s, const FluidCells<D>& cells) {
  const int size = static_cast<int>(s.size());
  counts_.assign(size, 0);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) counts_[i] = s.kind[i] == Kind::fluid && !is_spray(s, i, cells);
  water_.clear();
  for (int i = 0; i < size; ++i)
    if (counts_[i]) water_.add(lattice_.axes(s.position[i]), 1);
  water_.sort();
}

template <int D>
bool SurfaceProfile<D>::is_spray(const State<D>& s, int i, const FluidCells<D>& cells) const {
  if (!s.surface[i]) return false;
  int close = 0;
  cells.near(s.position[i], [&](int j, const Vec<D>& offset) { close += j != i && offset.norm() < 1.5 * lattice_.l0; });
  return close < 2;
}

template <int D>
double SurfaceProfile<D>::crossing(int c) const {
  const Column& column = columns_[c];
  const int i = c % count(0), k = c / count(0);
  const double l0 = lattice_.l0, dy = 0.25 * l0, bottom = y(column.bottom);
  // That far above a whole layer of particles phi is 0.07.
  const double top = water_.top(i, k, bottom) + 1.25 * l0;
  double above = 0;
  for (double at = closed_ ? std::min(top, y(column.top)) : top; at > bottom; at -= dy) {
    const double open = 1 - beside_.sum(i, k, at);
    if (open < least_open) continue;
    const double here = (water_.sum(i, k, at) + mirrored_.sum(i, k, at)) / open;
    if (here >= 0.5) {
      const double level = at + dy * (here - 0.5) / (here - above);
      return closed_ ? std::min(level, y(column.top)) : level;
    }
    above = here;
  }
  return bottom;
}

template <int D>
double SurfaceProfile<D>::gas_below(int c) const {
  const Column& column = columns_[c];
  if (!closed_ || height_[c] < y(column.top) - lattice_.l0) return 0;
  const int i = c % count(0), k = c / count(0);
  const double dy = 0.5 * lattice_.l0;
  int empty = 0;
  for (double at = height_[c] - dy; at > y(column.bottom); at -= dy) {
    const double open = 1 - beside_.sum(i, k, at);
    empty += open >= least_open && (water_.sum(i, k, at) + mirrored_.sum(i, k, at)) / open < 0.5;
  }
  return 0.5 * empty;
}

template LiquidLattice<3> lattice_of_columns(const Shape<3>&, const Gravity&, double);
template LiquidLattice<2> lattice_of_columns(const Shape<2>&, const Gravity&, double);
template class SurfaceProfile<2>;
template class SurfaceProfile<3>;

}  // namespace seiche::solver
