#pragma once
#include "solver/tank/shapes/section.hpp"

namespace seiche::solver {

/// A closed tank in 3-D that has one section all along z, between flat ends. Its patches are the section's, then near
/// (low z) and far.
class Extruded final : public Shape<3> {
 public:
  Extruded(Section section, double z_low, double z_high);

  /// Exact. Beyond an edge of the ends the normal is that of the wall which r is farther beyond.
  Nearest<3> nearest(const Vec<3>& r) const override;
  Bounds<3> bounds() const override;
  bool is_closed() const override { return true; }
  SurfaceMesh surface() const override;
  std::string description() const override { return described(bounds()); }
  /// The section's points in rows along z, and ends in rows along x; the layers of an end go on behind the side walls.
  std::vector<WallPoint<3>> wall_points(int layers, double l0, double reach) const override;

  /// [m^3]
  double volume() const { return section_.area() * (z_high_ - z_low_); }
  const Section& section() const { return section_; }
  double z_low() const { return z_low_; }
  double z_high() const { return z_high_; }

 private:
  Section section_;
  double z_low_, z_high_;
};

}  // namespace seiche::solver
