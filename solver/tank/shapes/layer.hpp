#pragma once
#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// A point of a layer behind a section's wall, and the piece of the layer's curve that it stands for.
struct LayerPoint {
  Vec<2> position;
  double length;  ///< [m]
  double moment;  ///< integral of the first coordinate over that length [m^2]
};

/// Points on the curve (layer + 1/2) l0 behind the wall, about l0 apart: between corners that turn by 30 degrees or
/// more, each with a point on its mitre, the length is split into round(length/l0) equal spacings. In a solid between
/// two walls that is thicker than 2 l0, the last layer of either side stands for what is left up to the middle.
/// @param last whether no layer follows
/// @param right_half only what has no negative first coordinate; where the curve meets the second axis, the first
///        point is half a spacing from it
std::vector<LayerPoint> layer_points(const Contour& wall, int layer, bool last, double l0, bool right_half = false);

}  // namespace seiche::solver
