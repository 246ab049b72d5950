#pragma once

namespace seiche::solver {

// How fine the mesh of a tank's surface is where that curves: volumes are within 1e-4.

/// How far chords of a 2-D or extruded wall lie off its curves, in sizes of the tank: 8e-5 of a circle's area.
inline constexpr double chord_tolerance = 3e-5;
/// The same of the profile of a body of revolution: 5e-5 of a sphere's volume.
inline constexpr double profile_tolerance = 1.25e-5;
/// Facets around a body of revolution: 5e-5 of its volume.
inline constexpr int facets_around = 364;

}  // namespace seiche::solver
