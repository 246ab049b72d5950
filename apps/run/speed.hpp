#pragma once
#include <map>
#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace seiche::apps {

/// Where the wall-clock time of a run went [s].
struct Times {
  std::map<std::string, double> stages;   ///< of a step
  std::map<std::string, double> outputs;  ///< on their own thread, beside the steps
  double waited = 0;                      ///< the solver for the outputs: queue full, or steps done
  double total = 0;

  double solver() const;  ///< all stages
};

/// Fluid particles times steps over the solver's time [1/s]; 0 where there is none.
double particle_steps_per_second(const Statistics& statistics, const Times& times);

/// Share of the wall time that the outputs held the run up.
double waited_share(const Times& times);

/// As in "412,000 particle-steps a second: solve 48 %, assembly 20 %, other 32 %": shares of the solver's time.
std::string speed_text(const Statistics& statistics, const Times& times);

/// As in "pictures 25 s, vtu 1.2 s beside the steps; held the run up by 0.3 s (1 %)".
std::string outputs_text(const Times& times);

}  // namespace seiche::apps
