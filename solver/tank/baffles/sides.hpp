#pragma once
#include "solver/tank/baffles/rims.hpp"

namespace seiche::solver {

/// The sides of a flat baffle with its rims prolonged: that at +normal, that at -normal, and, where it is thick, those
/// at the rims that end in the liquid.
std::vector<BaffleFace<3>> sides_of(const FlatBaffle& longer, const Rims& rims);

/// What stands behind sides of a baffle in a tank.
struct SidePoints {
  const Shape<3>& tank;
  int layers;
  double l0, reach;
  int patch;  ///< the baffle's

  /// Adds the points of layers behind a side, as far as liquid before it may see them past its ends: there they are as
  /// wet as the wall before them, like the second layer. Where they stand behind the tank's wall, too, it is that
  /// wall's slope that goes on.
  void add(const BaffleFace<3>& face, int number, std::vector<WallPoint<3>>& points) const;

 private:
  void add_flat(const FlatSide& side, int number, std::vector<WallPoint<3>>& points) const;
  void add_round(const RoundSide& side, int number, std::vector<WallPoint<3>>& points) const;
  /// A column of points behind a place of the side.
  template <class At, class Normal>
  void add_column(const Vec<3>& foot, double beyond, int number, At at, Normal normal,
                  std::vector<WallPoint<3>>& points) const;
};

}  // namespace seiche::solver
