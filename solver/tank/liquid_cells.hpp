#pragma once
#include <cmath>
#include <map>

#include "solver/tank/cell_part.hpp"

namespace seiche::solver {

/// The lattice of a tank's liquid: rows down from its level and parallel to it, columns about the middle of the tank.
/// Where that is a whole number of spacings from the tank's lowest corner, cells begin at the corner itself.
template <int D>
struct LiquidLattice {
  using Cell = Eigen::Matrix<int, D, 1>;

  LevelAxes<D> axes;  ///< along which its cells lie
  Vec<D> corner;      ///< of cell 0, along them [m]
  Cell count;         ///< of cells along each axis: they cover the tank up to the level
  double l0;          ///< [m]

  /// @param tank along the axes
  /// @param level along them [m]
  LiquidLattice(const Bounds<D>& tank, double level, double spacing, const LevelAxes<D>& along = LevelAxes<D>())
      : axes(along), l0(spacing) {
    for (int a = 0; a < D; ++a) {
      const double size = a == 1 ? level - tank.low[1] : tank.size()[a];
      count[a] = a == 1 ? static_cast<int>(std::ceil(size / l0 - 1e-6)) : static_cast<int>(std::lround(size / l0));
      corner[a] = a == 1 ? level - count[a] * l0 : tank.low[a] + 0.5 * (size - count[a] * l0);
      if (std::abs(corner[a] - tank.low[a]) < 1e-6 * l0)
        corner[a] = tank.low[a];
      else if (corner[a] > tank.low[a])
        corner[a] -= l0, count[a] += 2;
    }
  }

  /// In the tank's frame.
  Vec<D> centre(const Cell& cell) const {
    return axes.in_tank(corner + Vec<D>((cell.template cast<double>().array() + 0.5) * l0));
  }

  /// The one in which a place in the tank's frame lies.
  Cell cell_at(const Vec<D>& r) const { return ((axes(r) - corner) / l0).array().floor().template cast<int>(); }

  CellPart<D> part_inside(const Shape<D>& tank, const Cell& cell) const {
    return solver::part_inside(tank, centre(cell), l0, axes);
  }

  /// Calls f(cell) for each, x first, then y, then z.
  template <class F>
  void each(F f) const {
    if ((count.array() <= 0).any()) return;
    for (Cell c = Cell::Zero(); c[D - 1] < count[D - 1];) {
      f(c);
      for (int a = 0; ++c[a] == count[a] && a < D - 1; ++a) c[a] = 0;
    }
  }
};

/// Which of the cells that a wall cuts have a particle: as many of them as the liquid in them fills, spread evenly.
/// What a cell's share of liquid, with what its neighbours left, falls short of a particle or goes beyond one is passed
/// on to its neighbours that come later (error diffusion, Floyd & Steinberg 1976), rows from the top and each the other
/// way than the one before (Ulichney 1987), so that nothing drifts to one side: each wall has what lies beside it.
/// Chosen by the distance to the wall alone, liquid would lie more to one side and slosh.
template <int D>
class CutCells {
 public:
  using Cell = typename LiquidLattice<D>::Cell;

  /// @param part of the cell, by its number: baffles may cut it into several, which don't see each other
  void add(const Cell& cell, int part, double share, const Vec<D>& centroid) {
    cells_.emplace(key(cell, part), Cut{cell, part, share, centroid});
  }

  /// Parts pass on only to what they see.
  explicit CutCells(const Baffles<D>* baffles = nullptr) : baffles_(baffles) {}

  /// @param wanted particles in all cut cells: the last few are chosen such that it is met
  void choose(long wanted) {
    double carried = 0;
    long kept = 0;
    for (auto& [at, cut] : cells_) {
      cut.sum += cut.share + carried;
      carried = 0;
      cut.kept = cut.sum >= 0.5;
      kept += cut.kept;
      pass_on(at, cut, carried);
    }
    for (; kept != wanted; kept += kept < wanted ? 1 : -1)
      if (!change_one(kept < wanted)) return;
  }

  bool has_particle(const Cell& cell, int part) const { return cells_.at(key(cell, part)).kept; }

 private:
  struct Cut {
    Cell cell;
    int part;
    double share;
    Vec<D> centroid;
    double sum = 0;
    bool kept = false;
  };
  using Key = std::array<int, D + 1>;

  static int turned(int at, int row) { return row % 2 == 0 ? at : -at; }

  static Key key(const Cell& cell, int part) {
    Key key;
    key[D] = part;
    key[0] = -cell[1];
    key[1] = turned(cell[0], cell[1]);
    if constexpr (D == 3) key[2] = turned(cell[2], cell[0] + cell[1]);
    return key;
  }

  void pass_on(const Key& at, const Cut& cut, double& carried) {
    constexpr int around = D == 2 ? 9 : 27;
    std::vector<Cut*> later;
    for (int k = 0; k < around; ++k) {
      Cell other = cut.cell;
      for (int a = 0, rest = k; a < D; ++a, rest /= 3) other[a] += rest % 3 - 1;
      for (auto found = cells_.lower_bound(key(other, 0)); found != cells_.end() && found->second.cell == other;
           ++found)
        if (found->first > at && (!baffles_ || baffles_->sees(cut.centroid, found->second.centroid)))
          later.push_back(&found->second);
    }
    const double rest = cut.sum - cut.kept;
    if (later.empty()) carried = rest;
    for (Cut* other : later) other->sum += rest / static_cast<double>(later.size());
  }

  /// Gives a particle to the cell that came nearest to one, or takes it from the cell that least had it.
  bool change_one(bool more) {
    Cut* best = nullptr;
    for (auto& [at, cut] : cells_)
      if (cut.kept != more && (!best || (more ? cut.sum > best->sum : cut.sum < best->sum))) best = &cut;
    if (best) best->kept = more;
    return best != nullptr;
  }

  const Baffles<D>* baffles_;
  std::map<Key, Cut> cells_;
};

}  // namespace seiche::solver
