#pragma once
#include <memory>

#include "solver/tank/baffles/outline.hpp"

namespace seiche::solver {

/// A tank in 2-D with baffles in it. Its patches are the tank's, then one for each baffle: "baffle", or "baffle_1",
/// "baffle_2", ... if there are several.
class Baffled final : public Shape<2> {
 public:
  /// An end of a baffle that is nearer to the tank's wall than this is on it [l0].
  static constexpr double touching = 0.1;

  /// @param reach of a pair of particles [m]. Throws BadParameters as `outline_of` does, and where a baffle lies
  /// outside
  ///        the tank.
  Baffled(std::shared_ptr<const Shape<2>> tank, const std::vector<BaffleLine>& baffles, double l0, double reach);

  /// The tank's wall and that of baffles with a thickness; exact. Plates have liquid on both sides: to them it is
  /// blind.
  Nearest<2> nearest(const Vec<2>& r) const override;
  Bounds<2> bounds() const override { return tank_->bounds(); }
  bool is_closed() const override { return tank_->is_closed(); }
  /// Without what of the wall lies within baffles, and of the baffles outside the wall; both sides of plates.
  SurfaceMesh surface() const override;
  /// Those of the tank, and behind each side of a baffle those of a solid without an end, as far as liquid before that
  /// side may see them.
  std::vector<WallPoint<2>> wall_points(int layers, double l0, double reach) const override;
  std::shared_ptr<const Baffles<2>> baffles() const override { return faces_; }
  /// Of each baffle, as `outline_of`: of those with a thickness, and of plates.
  std::vector<std::vector<Vec<2>>> solids() const;
  std::vector<std::vector<Vec<2>>> plates() const;
  std::string description() const override { return tank_->description(); }

 private:
  /// A side of a baffle within the tank, and what each end is: on the tank's wall, a plate's rim, or none of them.
  struct Side {
    Vec<2> from, to;
    bool from_wall, to_wall;
    bool from_rim, to_rim;  ///< whether a plate ends there
    int baffle;
  };

  bool is_in_solid(const Vec<2>& r) const;
  void add_sides(int baffle, double l0);
  /// A point of the tank's wall, or where sides of baffles cut the length that it stands for, a point for each part:
  /// each side's liquid sees its own alone.
  void add_parts(const WallPoint<2>& point, double l0, std::vector<WallPoint<2>>& points) const;
  void add_points(const Side& side, int face, int layers, double l0, double reach,
                  std::vector<WallPoint<2>>& points) const;

  std::shared_ptr<const Shape<2>> tank_;
  std::vector<std::vector<Vec<2>>> outlines_;  ///< of each baffle, as `outline_of`
  std::vector<int> solid_of_;                  ///< of each baffle its place in `solids_`, -1 of a plate
  std::vector<Contour> solids_;
  std::vector<std::string> patches_;  ///< the tank's
  std::vector<std::string> names_;    ///< of the baffles' patches
  std::vector<Side> sides_;
  std::shared_ptr<const Baffles<2>> faces_;
};

}  // namespace seiche::solver
