#pragma once
#include <vector>

#include "tests/bench/child.hpp"

namespace seiche::bench {

/// The mean step of a sloshing tank.
struct StepCost {
  long fluid = 0;  ///< particles
  int threads = 0;
  double iterations = 0;  ///< of the pressure solver a step
  double bytes = 0;       ///< of resident memory a fluid particle
  Numbers microseconds;   ///< a fluid particle, by stage; "rest" is what no stage has

  double whole() const;  ///< microseconds of all stages
};

/// Some `particles` fluid particles in the tank of Pan, Zhang and Lu (2008), but surging by 0.05 m: 60 steps, in which
/// the fastest go a few spacings, then 20 by the clock. Memory is what the process holds more at their end.
StepCost measure_steps(int particles, int threads);

/// One line each.
std::string steps_csv(const std::vector<StepCost>& costs);

}  // namespace seiche::bench
