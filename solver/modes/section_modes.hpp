#pragma once
#include "solver/modes/elements.hpp"
#include "solver/modes/outline.hpp"

namespace seiche::solver::modes {

/// A wave of small height in a tank that is still.
struct Mode {
  double frequency;               ///< angular [rad/s]
  std::vector<double> elevation;  ///< at each point of the free surface, the greatest 1 or -1
};

/// The waves of one body of liquid.
struct Chamber {
  std::vector<double> across;  ///< first coordinate of points of the free surface, ascending [m]
  std::vector<Mode> modes;     ///< the slowest first
};

/// First modes of the liquid below a level: Laplace's equation for the potential, no flow through walls,
/// d phi/dn = omega^2/g phi on the free surface; quadratic finite elements, condensed to the surface. Curves are
/// polygons fine enough for the accuracy that is wanted. Throws BadParameters as `liquid_below` does, for a section
/// that crosses itself, a gravity that isn't greater than 0, and a negative radius.
/// @param section closed loops, outer ones anticlockwise, holes clockwise; a plate without thickness goes there and
/// back [m]
/// @param level of the free surface [m]
/// @param gravity [m/s^2]
/// @param count of modes in each chamber
/// @param along triangles along the free surface; 0: as many as the modes need
std::vector<Chamber> section_modes(const Polygons& section, double level, double gravity, int count,
                                   const Across& across = {}, int along = 0);

}  // namespace seiche::solver::modes
