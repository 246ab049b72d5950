#pragma once
#include "solver/tank/mesh/layer_surface.hpp"
#include "solver/tank/mesh/shell.hpp"

namespace seiche::solver {

/// A point of a layer and the volume of the pieces that are nearest to it [l0^3].
struct SpreadPoint {
  Vec<3> at;
  double volume = 0;
};

/// Points on a layer's surface, about l0 apart: those at mitres, and between them others that settle in the middles of
/// their pieces (Lloyd 1982).
/// @param pieces that they share
/// @param left those that are too far from any, as in a solid too thin for the layer
std::vector<SpreadPoint> spread_points(const LayerSurface& surface, const std::vector<ShellPiece>& pieces, double l0,
                                       std::vector<ShellPiece>& left);

}  // namespace seiche::solver
