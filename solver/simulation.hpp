#pragma once
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/frame.hpp"
#include "solver/parameters.hpp"

namespace seiche {

/// The run can't go on: says when, where and why, in one sentence fit for the user.
struct RunFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The parameters don't fit together: which, why, and what to do, in one sentence fit for the user.
struct BadParameters : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Running totals since the start.
struct Statistics {
  long steps = 0;
  long iterations = 0;  ///< of the pressure solver, all steps together
  int last_iterations = 0;
  double last_residual = 0;  ///< relative, of the last solve
  double worst_residual = 0;
  long list_builds = 0;      ///< times the neighbour list was made anew
  double shortest_step = 0;  ///< [s]
  double longest_step = 0;   ///< [s]
  /// of any two particles but dummies, whenever a step measured its pairs [m]
  double least_distance = std::numeric_limits<double>::infinity();
  long fluid_particles = 0;  ///< still in the run
  long wall_particles = 0;
  long dummy_particles = 0;
  long leaked = 0;                        ///< fluid particles that went through a wall, and were taken out
  long spilled = 0;                       ///< fluid particles that left an open tank over its rim, and were taken out
  std::map<std::string, double> seconds;  ///< wall-clock time by stage of a step
};

/// A tank of particles that can be stepped through time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Takes one step, of a length by the rule of equation (18), such that some step ends exactly at `until`:
  /// what is left to `until` is split into equal steps. Throws RunFailure; the state is then the one that the run broke
  /// off in, whose values may not be finite.
  virtual void step(double until) = 0;

  virtual double time() const = 0;
  virtual const Statistics& statistics() const = 0;

  /// The state now, as frame number `index`, with the sensor readings taken since the last call.
  virtual FramePtr frame(long index) = 0;
};

/// A run at t = 0. Throws BadParameters.
/// @param sample_interval between two sensor readings [s]; 0: no sensors
std::unique_ptr<Simulation> make_simulation(const Parameters& parameters, double sample_interval);

/// Column names with units of `Frame::readings`, as in "p_left_bottom [Pa]".
std::vector<std::string> sensor_columns(const Parameters& parameters);

/// Replaces everything that a preset governs, "paper" or "stabilised", by its values, and sets `preset`.
void apply_preset(Parameters& parameters, const std::string& preset);

/// Throws BadParameters where the parameters don't fit together (a length that is no whole number of spacings ...).
void check_parameters(const Parameters& parameters);

/// No point of the tank, wall particles included, is ever displaced by more on each axis [m].
Double3 motion_extent(const Parameters& parameters);

}  // namespace seiche
