#pragma once
#include <string>

#include "solver/modes/section_modes.hpp"
#include "solver/tank/body.hpp"

namespace seiche::solver::modes {

/// A wave of small height in a tank that is still, without its form.
struct TankMode {
  double frequency;  ///< angular [rad/s]
  std::string wave;  ///< as in "across", "1 half wave along z", "1 wave round the axis"
  double from, to;   ///< first coordinate of the ends of its chamber's free surface in the section [m]
};

// The first modes of all chambers of a tank filled to a level, the slowest first; gravity points along -y. Waves that
// differ by a turn about an upright axis alone count once. Curves are polygons within 1e-5 of the tank's size, which
// keeps frequencies within 0.01 %. Each throws BadParameters as `section_modes` does.
//   level: y of the still surface [m]; gravity [m/s^2]; count of modes.

/// In 2-D.
std::vector<TankMode> tank_modes(const Section& tank, double level, double gravity, int count);

/// phi = cos(n pi (z - z_low) / length) times a function of the section.
std::vector<TankMode> tank_modes(const Extruded& tank, double level, double gravity, int count);

/// Upright: phi = cos(m theta) times a function of the profile. Lying between flat ends: as an extruded circle. Empty
/// for other lying tanks, whose modes no section gives.
std::vector<TankMode> tank_modes(const Revolved& tank, double level, double gravity, int count);

/// Empty: no section gives the modes of a mesh.
std::vector<TankMode> tank_modes(const MeshTank& tank, double level, double gravity, int count);

/// Of a run's tank, its liquid still. Empty for a tank that leans, unless that is a section or leans across the length
/// of one.
std::vector<TankMode> tank_modes(const Parameters& p, int count);

/// A contour's loops as polygons within a share of its size.
Polygons polygons_of(const Contour& contour, double share = 1e-5);

}  // namespace seiche::solver::modes
