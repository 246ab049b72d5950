#pragma once
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// A box with a corner at the origin. Patches: left, right (x), near, far (z, in 3-D), floor, roof (y).
template <int D>
class Box final : public Shape<D> {
 public:
  explicit Box(const Parameters& p);

  /// Exact. Where several walls are as near, the first of left, right, near, far, floor, roof.
  Nearest<D> nearest(const Vec<D>& r) const override;
  Bounds<D> bounds() const override { return {Vec<D>::Zero(), size_}; }
  bool is_closed() const override { return closed_; }
  SurfaceMesh surface() const override;
  /// On the lattice whose cells fill the box, in its order.
  std::vector<WallPoint<D>> wall_points(int layers, double l0, double reach) const override;
  std::string description() const override;

 private:
  Vec<D> size_;  ///< inner length, height(, width) [m]
  bool closed_;
};

/// Whether its sides are whole numbers of spacings.
bool fits_lattice(const Parameters& p);

/// Throws BadParameters unless its sides are whole numbers of spacings, four at least.
void check_box(const Parameters& p);

}  // namespace seiche::solver
