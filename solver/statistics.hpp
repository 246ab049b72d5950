#pragma once
#include <limits>
#include <map>
#include <string>

namespace seiche {

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

}  // namespace seiche
