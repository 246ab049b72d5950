#pragma once
#include <algorithm>
#include <limits>
#include <numeric>

#include "solver/sensors/fluid_cells.hpp"
#include "solver/sensors/lattice_columns.hpp"

namespace seiche::solver {

/// The lattice whose columns the surface is found over: all of the tank.
template <int D>
LiquidLattice<D> lattice_of_columns(const Shape<D>& tank, const Gravity& gravity, double l0) {
  const LevelAxes<D> axes(gravity);
  const Bounds<D> bounds = axes.bounds_of(tank);
  return {bounds, bounds.high[1], l0, axes};
}

/// The water surface over the columns of the lattice, which stand upright on the level: for each the highest crossing
/// of half of the fluid fraction
///   phi(x, y) = (sum_fluid W + sum_wall n^2 v s W) / (1 - sum_wall (1 - n^2) v W),   W as LatticeColumns has it.
/// n is how far the wall at a wall particle faces up or down, the y of the direction to its nearest point in the tank.
/// Beside a wall the fluid goes on as it is at the same height; below the floor as in a mirror: a particle of volume v
/// [l0^D] is fluid by the share at its mirror point,
///   s = sum_fluid H / (1 - sum_wall v H),   H = prod_axis max(0, 1 - |x|/l0).
/// A lattice at rest has phi = 1 below its surface, 1/2 on it and 0 above. Spray, fluid at the free surface with fewer
/// than two fluid neighbours within 1.5 l0, doesn't count.
template <int D>
class SurfaceProfile {
 public:
  /// @param walls a state with the tank's wall particles and dummies
  SurfaceProfile(const Shape<D>& tank, const Gravity& gravity, double l0, const State<D>& walls)
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

  /// Finds the surface. Second order in l0.
  void find(const State<D>& s, const FluidCells<D>& cells) {
    sort(s, cells);
    fill_mirrors();
    const int columns = static_cast<int>(height_.size());
#pragma omp parallel for schedule(static)
    for (int c = 0; c < columns; ++c) {
      height_[c] = crossing(c);
      gas_[c] = gas_below(c);
    }
  }

  const LiquidLattice<D>& lattice() const { return lattice_; }

  /// phi at any place in the tank's frame; 0 where walls leave too little of it.
  double fraction(const Vec<D>& r) const {
    const Vec<D> at = lattice_.axes(r);
    const double open = 1 - beside_.sum(at);
    return open < least_open ? 0 : (water_.sum(at) + mirrored_.sum(at)) / open;
  }

  /// Columns along x, and along z (1 in 2-D).
  int count(int axis) const { return axis == 0 ? lattice_.count[0] : D == 3 ? lattice_.count[D - 1] : 1; }

  /// The surface's y along the lattice's axes [m] in column i + count(0) k, the column's bottom where there is no
  /// water.
  double height(int column) const { return height_[column]; }

  /// Space below the surface [m^2 in 2-D, m^3]; NaN where more than a hundredth of it is gas below liquid at the roof.
  double volume() const {
    double cells = 0;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      cells += columns_[c].cells_below((height_[c] - lattice_.corner[1]) / lattice_.l0, closed_);
    const double gas = std::accumulate(gas_.begin(), gas_.end(), 0.0);
    return gas > 0.01 * cells ? std::numeric_limits<double>::quiet_NaN() : cells * std::pow(lattice_.l0, D);
  }

 private:
  using Cell = typename LiquidLattice<D>::Cell;

  /// Less of a place than that is left by the walls: it lies behind them.
  static constexpr double least_open = 0.25;

  /// What a wall particle shows of the fluid.
  struct Mirror {
    Vec<D> point;   ///< along the lattice's axes [m]
    double weight;  ///< n^2 v / (1 - sum_wall v H)
  };

  /// What of the tank is in a column, in cells, from the lattice's corner up.
  struct Column {
    Scalars below;  ///< of the tank below each cell, and below the column's end
    double bottom = 0, top = 0;

    void add_cell(double share) {
      const auto at = static_cast<double>(below.size() - 1);
      if (below.back() == 0) bottom = at + 1 - share;
      if (share > 0) top = at + share;
      below.push_back(below.back() + share);
    }

    double cells_below(double height, bool closed) const {
      const auto rows = static_cast<double>(below.size() - 1);
      if (height >= rows) return below.back() + (closed ? 0 : height - rows);
      const double whole = std::floor(std::max(0.0, height)), rest = std::max(0.0, height) - whole;
      const auto at = static_cast<std::size_t>(whole);
      return below[at] + rest * (below[at + 1] - below[at]);
    }
  };

  int number(const Cell& cell) const { return cell[0] + (D == 3 ? count(0) * cell[D - 1] : 0); }
  double y(double cells) const { return lattice_.corner[1] + cells * lattice_.l0; }

  void add_walls(const Shape<D>& tank, const State<D>& walls) {
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

  /// Of what a particle behind a side of a baffle stands for, what lies in the half of the baffle on that side.
  double share_in_baffle(const Shape<D>& tank, const BaffleFace<D>& face, const Vec<D>& r) const {
    const double depth = face.behind(r), l0 = lattice_.l0, step = 0.02 * l0;
    const Vec<D> normal = face.normal_at(r), foot = face.foot(r);
    if (!face.holds(foot) || tank.nearest(foot - step * normal).distance > 0) return 0;
    double half = 0;
    while (half < depth + l0 && tank.nearest(foot + 2 * (half + step) * normal).distance > 0) half += step;
    return std::clamp((half - depth) / l0 + 0.5, 0.0, 1.0);
  }

  void fill_mirrors() {
    const int size = static_cast<int>(mirrors_.size());
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) mirrored_.set_weight(i, mirrors_[i].weight * water_.linear_sum(mirrors_[i].point));
  }

  void sort(const State<D>& s, const FluidCells<D>& cells) {
    const int size = static_cast<int>(s.size());
    counts_.assign(size, 0);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) counts_[i] = s.kind[i] == Kind::fluid && !is_spray(s, i, cells);
    water_.clear();
    for (int i = 0; i < size; ++i)
      if (counts_[i]) water_.add(lattice_.axes(s.position[i]), 1);
    water_.sort();
  }

  bool is_spray(const State<D>& s, int i, const FluidCells<D>& cells) const {
    if (!s.surface[i]) return false;
    int close = 0;
    cells.near(s.position[i],
               [&](int j, const Vec<D>& offset) { close += j != i && offset.norm() < 1.5 * lattice_.l0; });
    return close < 2;
  }

  double crossing(int c) const {
    const Column& column = columns_[c];
    const int i = c % count(0), k = c / count(0);
    const double l0 = lattice_.l0, dy = 0.25 * l0, bottom = y(column.bottom);
    const double top = water_.top(i, k, bottom) + 2 * l0;
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

  /// Cells of a column whose liquid reaches the roof that are gas.
  double gas_below(int c) const {
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

  LiquidLattice<D> lattice_;
  bool closed_;
  LatticeColumns<D> beside_, mirrored_, water_;
  std::vector<Mirror> mirrors_;  ///< of the points in mirrored_
  std::vector<Column> columns_;
  Scalars height_;
  Scalars gas_;                       ///< below liquid at the roof, in each column [cells]
  std::vector<std::uint8_t> counts_;  ///< a buffer
};

}  // namespace seiche::solver
