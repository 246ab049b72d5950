#pragma once
#include <vector>

#include "solver/parameters.hpp"
#include "solver/tank/liquid_cells.hpp"

namespace seiche::solver {

/// Liquid at rest with one level: what of the cells of its lattice it fills.
template <int D>
struct Pool {
  using Cell = typename LiquidLattice<D>::Cell;

  struct Part {
    Cell cell;
    int number;  ///< in its cell
    CellPart<D> inside;
  };

  LiquidLattice<D> lattice;
  double level;   ///< along the lattice's axes [m]
  double volume;  ///< [m^2 in 2-D, m^3]
  std::vector<Part> parts;
};

/// All that lies below a level, of a column what lies in it.
/// @param depth of the level above the lowest point of the tank [m]
template <int D>
Pool<D> pool_below(const Parameters& p, const Shape<D>& tank, double depth);

/// Of a pool what joins the cell in which a point lies. Its volume is the sum of its parts, within some 1e-3 of those
/// that a wall cuts. Empty where the point is outside the tank or above the level.
template <int D>
Pool<D> pool_about(Pool<D> pool, const Shape<D>& tank, const Vec<D>& point);

template <int D>
Vec<D> point_of(const Parameters::Fluid::Seed& seed) {
  return Vec<3>(seed.x, seed.y, seed.z).template head<D>();
}

/// One for each seed in their order; without seeds one of all that lies below the level.
template <int D>
std::vector<Pool<D>> pools_of(const Parameters& p, const Shape<D>& tank);

/// The same liquid at rest under what acts at t = 0: as much of it in each pool.
template <int D>
std::vector<Pool<D>> pools_of(const Parameters& p, const Shape<D>& tank, const RelativeEquilibrium& at_rest);

/// Those of pools_of(p, tank) where levels alone are asked for: one without parts where there are no seeds.
template <int D>
std::vector<Pool<D>> levels_of(const Parameters& p, const Shape<D>& tank);

/// Volume of the liquid, of a column that of a tank as deep [m^2 in 2-D, m^3].
double liquid_volume(const Parameters& p);

/// Whether liquid of one lies where the other's does.
template <int D>
bool meet(const Pool<D>& a, const Pool<D>& b, const Baffles<D>* baffles);

/// Level of the pool with liquid above, below or else nearest beside a place [m].
template <int D>
double level_beside(const std::vector<Pool<D>>& pools, const Vec<D>& r);

}  // namespace seiche::solver
