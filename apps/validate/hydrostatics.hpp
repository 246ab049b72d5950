#pragma once
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

// What a frame of liquid at rest ought to be: still, at the pressure p = rho g (level - y).
namespace seiche::apps::validate {

/// Root mean square over the fluid of what its pressure differs from that by, over rho g depth [-].
double hydrostatic_error(const Frame& frame, const RunInfo& run);

/// Greatest speed [m/s].
double greatest_speed(const Frame& frame);

}  // namespace seiche::apps::validate
