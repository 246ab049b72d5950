#pragma once
#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// How long the triangles of a body of liquid may be, in its grid's units: short at the free surface, longer with
/// depth, as waves fade; very short at corners that stick out into the liquid, where the velocity has no bound (it goes
/// with the distance to the power pi/angle - 1), and short at other blunt corners.
class ElementSize {
 public:
  /// @param along triangles along the free surface
  /// @param longest at the free surface [m]
  ElementSize(const Outline& outline, int along, double longest);

  double operator()(const Vec<2>& at) const;

 private:
  struct Source {
    Vec<2> at;
    double size;
  };

  void add(const Loop& loop);

  double level_ = 0, at_surface_, growth_;
  std::vector<Source> sources_;
};

}  // namespace seiche::solver::modes
