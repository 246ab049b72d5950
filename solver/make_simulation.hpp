#pragma once
#include <memory>
#include <vector>

#include "solver/column.hpp"
#include "solver/errors.hpp"
#include "solver/frame.hpp"
#include "solver/parameters.hpp"
#include "solver/simulation.hpp"
#include "solver/surface_mesh.hpp"

// What a run is made of, before it has begun.
namespace seiche {

/// A run at t = 0. Throws BadParameters.
/// @param sample_interval between two sensor readings [s]; 0: no sensors
std::unique_ptr<Simulation> make_simulation(const Parameters& parameters, double sample_interval);

/// The columns of `Frame::readings`.
std::vector<Column> sensor_columns(const Parameters& parameters);

/// The wall of the tank, in its frame.
SurfaceMesh tank_surface(const Parameters& parameters);

/// No point of the tank, wall particles included, is ever displaced by more on each axis [m].
Double3 motion_extent(const Parameters& parameters);

}  // namespace seiche
