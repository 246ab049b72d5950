#pragma once
#include <algorithm>
#include <cmath>

#include "solver/sensors/fluid_cells.hpp"
#include "solver/sensors/lattice_columns.hpp"

namespace seiche::solver {

/// The lattice whose columns the surface is found over: all of the tank.
template <int D>
LiquidLattice<D> lattice_of_columns(const Shape<D>& tank, const Gravity& gravity, double l0);

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
  SurfaceProfile(const Shape<D>& tank, const Gravity& gravity, double l0, const State<D>& walls);

  /// Finds the surface. Second order in l0.
  void find(const State<D>& s, const FluidCells<D>& cells);

  const LiquidLattice<D>& lattice() const { return lattice_; }

  /// phi at any place in the tank's frame; 0 where walls leave too little of it.
  double fraction(const Vec<D>& r) const;

  /// Columns along x, and along z (1 in 2-D).
  int count(int axis) const { return axis == 0 ? lattice_.count[0] : D == 3 ? lattice_.count[D - 1] : 1; }

  /// The surface's y along the lattice's axes [m] in column i + count(0) k, the column's bottom where there is no
  /// water.
  double height(int column) const { return height_[column]; }

  /// Space below the surface [m^2 in 2-D, m^3]; NaN where more than a hundredth of it is gas below liquid at the roof.
  double volume() const;

 private:
  using Cell = typename LiquidLattice<D>::Cell;

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

  void add_walls(const Shape<D>& tank, const State<D>& walls);

  /// Of what a particle behind a side of a baffle stands for, what lies in the half of the baffle on that side.
  double share_in_baffle(const Shape<D>& tank, const BaffleFace<D>& face, const Vec<D>& r) const;

  void fill_mirrors();

  void sort(const State<D>& s, const FluidCells<D>& cells);

  bool is_spray(const State<D>& s, int i, const FluidCells<D>& cells) const;

  double crossing(int c) const;

  /// Cells of a column whose liquid reaches the roof that are gas.
  double gas_below(int c) const;

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
