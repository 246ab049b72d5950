#pragma once
#include <memory>
#include <string>
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

/// The tank of that shape before a scene says more: a box has measures to start from, the others none.
Parameters::Tank initial_tank(TankShape shape);

/// Throws BadParameters where the tank's measures don't make a tank that particles can line.
void check_tank(const Parameters& parameters);

struct TankMeasures {
  double volume;  ///< of all the tank [m^2 in 2-D, m^3]
  double area;    ///< of its wall [m in 2-D, m^2]
  double height;  ///< against gravity [m]
  double liquid;  ///< volume of the liquid, of a column that of a whole tank [m^2, m^3]
};
TankMeasures tank_measures(const Parameters& parameters);

/// The depth [m] at which the tank holds that volume of liquid, all its height if it holds less.
double depth_holding(const Parameters& parameters, double volume);

/// What was mended of the tank's mesh, as in "2 holes closed, the widest 0.001 m across"; empty where nothing was.
std::string mended_of(const Parameters& parameters);

/// A wave of small height in a tank that is still.
struct NaturalMode {
  double period;     ///< [s]
  std::string wave;  ///< as in "across", "1 half wave along z", "1 wave round the axis"
};

/// The first natural modes of the liquid by linear theory, the slowest first; none without gravity, of a dam break, of
/// chambers filled to levels of their own, and where no section of the tank gives them. Throws BadParameters.
std::vector<NaturalMode> natural_modes(const Parameters& parameters, int count);

/// What pulls the liquid: gravity, or the tank's greatest acceleration where that is more [m/s^2].
double greatest_pull(const Parameters& parameters);

/// No point of the tank, wall particles included, is ever displaced by more on each axis [m].
Double3 motion_extent(const Parameters& parameters);

}  // namespace seiche
