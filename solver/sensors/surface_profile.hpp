#pragma once
#include <algorithm>
#include <numeric>

#include "solver/sensors/fluid_cells.hpp"
#include "solver/sensors/lattice_columns.hpp"

namespace seiche::solver {

/// The water surface over the columns of the lattice: for each the highest crossing of half of the fluid fraction,
/// which is what of the space that the walls leave is fluid,
///   phi(x, y) = sum_fluid W / (1 - sum_wall v W),   W as LatticeColumns has it.
/// A lattice at rest has phi = 1 below its surface, 1/2 on it and 0 above. Spray, fluid at the free surface with fewer
/// than two fluid neighbours within 1.5 l0, doesn't count.
template <int D>
class SurfaceProfile {
 public:
  /// @param walls a state with the tank's wall particles and dummies
  SurfaceProfile(const Shape<D>& tank, double l0, const State<D>& walls)
      : lattice_(tank.bounds(), tank.bounds().high[1], l0),
        closed_(tank.is_closed()),
        solid_(lattice_),
        water_(lattice_) {
    columns_.resize(static_cast<std::size_t>(count(0)) * count(1));
    height_.resize(columns_.size());
    for (Column& column : columns_) column.below.assign(1, 0);
    lattice_.each(
        [&](const Cell& cell) { columns_[number(cell)].add_cell(part_inside(tank, lattice_.centre(cell), l0).share); });
    for (std::size_t i = 0; i < walls.size(); ++i)
      if (walls.kind[i] != Kind::fluid) solid_.add(walls.position[i], walls.volume[i]);
    solid_.sort();
  }

  /// Finds the surface. Second order in l0.
  void find(const State<D>& s, const FluidCells<D>& cells) {
    sort(s, cells);
    const int columns = static_cast<int>(height_.size());
#pragma omp parallel for schedule(static)
    for (int c = 0; c < columns; ++c) height_[c] = crossing(c);
  }

  const LiquidLattice<D>& lattice() const { return lattice_; }

  /// Columns along x, and along z (1 in 2-D).
  int count(int axis) const { return axis == 0 ? lattice_.count[0] : D == 3 ? lattice_.count[D - 1] : 1; }

  /// The surface's y [m] in column i + count(0) k, the column's bottom where there is no water.
  double height(int column) const { return height_[column]; }

  /// Space below the surface [m^2 in 2-D, m^3].
  double volume() const {
    double cells = 0;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      cells += columns_[c].cells_below((height_[c] - lattice_.corner[1]) / lattice_.l0, closed_);
    return cells * std::pow(lattice_.l0, D);
  }

 private:
  using Cell = typename LiquidLattice<D>::Cell;

  /// Less of a place than that is left by the walls: it lies behind them.
  static constexpr double least_open = 0.25;

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

  void sort(const State<D>& s, const FluidCells<D>& cells) {
    const int size = static_cast<int>(s.size());
    counts_.assign(size, 0);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) counts_[i] = s.kind[i] == Kind::fluid && !is_spray(s, i, cells);
    water_.clear();
    for (int i = 0; i < size; ++i)
      if (counts_[i]) water_.add(s.position[i], 1);
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
    double above = 0;
    for (double at = water_.top(i, k, bottom) + 2 * l0; at > bottom; at -= dy) {
      const double open = 1 - solid_.sum(i, k, at);
      if (open < least_open) continue;
      const double here = water_.sum(i, k, at) / open;
      if (here >= 0.5) {
        const double level = at + dy * (here - 0.5) / (here - above);
        return closed_ ? std::min(level, y(column.top)) : level;
      }
      above = here;
    }
    return bottom;
  }

  LiquidLattice<D> lattice_;
  bool closed_;
  LatticeColumns<D> solid_, water_;
  std::vector<Column> columns_;
  Scalars height_;
  std::vector<std::uint8_t> counts_;  ///< a buffer
};

}  // namespace seiche::solver
