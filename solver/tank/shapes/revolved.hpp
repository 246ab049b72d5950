#pragma once
#include "solver/tank/shapes/section.hpp"

namespace seiche::solver {

/// A closed tank in 3-D that a profile makes by turning about an axis along x, y or z.
class Revolved final : public Shape<3> {
 public:
  /// @param half what is turned, by (radius, height along the axis) [m]; its edges on the axis are no wall
  /// @param patches names by the patch of an edge
  /// @param axis 0, 1 or 2: x, y or z
  /// @param origin on the axis, at height 0 [m]
  Revolved(const Contour& half, std::vector<std::string> patches, int axis, const Vec<3>& origin);

  /// Exact: that of the profile and its mirror image.
  Nearest<3> nearest(const Vec<3>& r) const override;
  Bounds<3> bounds() const override;
  bool is_closed() const override { return true; }
  SurfaceMesh surface() const override;
  std::string description() const override { return described(bounds()); }
  /// Rings about the axis, each with the area that the piece of its layer's curve sweeps.
  std::vector<WallPoint<3>> wall_points(int layers, double l0, double reach) const override;

  /// [m^3]
  double volume() const;
  const Contour& half() const { return half_; }
  /// The profile and its mirror image, by (radius, height), radii on the left negative.
  const Contour& whole() const { return whole_; }
  const std::vector<std::string>& patches() const { return patches_; }
  int axis() const { return axis_; }
  const Vec<3>& origin() const { return origin_; }

 private:
  Vec<3> placed(double radius, double height, const Vec<3>& arm) const;
  /// Unit vector away from the axis at an angle [rad].
  Vec<3> arm(double angle) const;

  Contour half_, whole_;
  std::vector<std::string> patches_;
  int axis_;
  Vec<3> origin_;
  Bends bends_;
};

}  // namespace seiche::solver
