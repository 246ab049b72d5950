#pragma once
#include "render/picture/polyline.hpp"

namespace seiche::render {

/// An arrow along x, made of convex polygons; its middle is at 0. All sizes in one unit.
struct ArrowShape {
  Line shaft, head;            ///< dark
  Line shaft_halo, head_halo;  ///< light, a little larger, drawn below them
};

/// `font`: height of the picture's text, which shaft and head are in proportion to. Those of an arrow that is short for
/// its head are smaller.
ArrowShape arrow_shape(double length, double font);

/// The arrow at `middle`, turned to point along `direction`, which has length 1.
ArrowShape placed(const ArrowShape& arrow, const Point& middle, const Point& direction);

}  // namespace seiche::render
