#pragma once
#include "solver/tank/shape.hpp"
#include "solver/tank/shapes/bend.hpp"

namespace seiche::solver {

/// A closed tank in 2-D: what a contour goes round.
class Section final : public Shape<2> {
 public:
  /// @param patches names by the patch of an edge
  Section(Contour wall, std::vector<std::string> patches);

  Nearest<2> nearest(const Vec<2>& r) const override { return wall_.nearest(r); }
  Bounds<2> bounds() const override { return bounds_; }
  bool is_closed() const override { return true; }
  SurfaceMesh surface() const override;
  std::string description() const override;
  std::vector<WallPoint<2>> wall_points(int layers, double l0, double reach) const override;

  /// [m^2]
  double area() const { return wall_.area(); }
  const Contour& wall() const { return wall_; }
  const std::vector<std::string>& patches() const { return patches_; }

 private:
  Contour wall_;
  std::vector<std::string> patches_;
  Bends bends_;
  Bounds<2> bounds_;
};

/// As in "x from 0 to 0.6 m, y from 0 to 0.4 m, and has no z".
template <int D>
std::string described(const Bounds<D>& bounds);

}  // namespace seiche::solver
