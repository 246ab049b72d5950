#pragma once
#include <memory>

#include "solver/tank/baffles/rims.hpp"

namespace seiche::solver {

/// A tank in 3-D with flat baffles in it. Its patches are the tank's, then one for each baffle by its name, with
/// numbers where several have one.
class BaffledBody final : public Shape<3> {
 public:
  /// A rim that is nearer to the tank's wall than this all along is on it [l0].
  static constexpr double touching = 0.1;

  /// Rims on the tank's wall, or beyond it, go on behind it as far as a pair may see.
  /// @param reach of a pair of particles [m]. Throws BadParameters where a baffle lies outside the tank.
  BaffledBody(std::shared_ptr<const Shape<3>> tank, std::vector<FlatBaffle> baffles, double l0, double reach);

  /// The tank's wall and that of baffles with a thickness; exact. Plates have liquid on both sides: to them it is
  /// blind.
  Nearest<3> nearest(const Vec<3>& r) const override;
  Bounds<3> bounds() const override { return tank_->bounds(); }
  bool is_closed() const override { return tank_->is_closed(); }
  /// Without what of the wall lies within baffles, and of the baffles outside the wall; both sides of plates.
  SurfaceMesh surface() const override;
  /// Those of the tank, and behind each side of a baffle those of a solid without an end, as far as liquid before that
  /// side may see them.
  std::vector<WallPoint<3>> wall_points(int layers, double l0, double reach) const override;
  std::shared_ptr<const Baffles<3>> baffles() const override { return faces_; }
  std::string description() const override { return tank_->description(); }

 private:
  std::shared_ptr<const Shape<3>> tank_;
  std::vector<FlatBaffle> baffles_, longer_;  ///< as they were given, and with rims on the wall moved beyond it
  std::vector<Rims> rims_;
  std::vector<std::string> names_;  ///< of the baffles' patches
  int first_patch_ = 0;             ///< theirs, after the tank's
  std::shared_ptr<const Baffles<3>> faces_;
  std::vector<int> baffle_of_;  ///< of each face
  double l0_;
};

}  // namespace seiche::solver
