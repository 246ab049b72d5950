#pragma once
#include <string>
#include <utility>
#include <vector>

#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

using Notes = std::vector<std::pair<std::string, std::string>>;

/// Where a run's outputs come from: Software, Title, Scene hash, Parameters. No wall clock, so that the same scene
/// gives the same files.
Notes provenance(const RunInfo& run);

/// The same for one frame of it: adds Time and Step.
Notes provenance(const RunInfo& run, const Frame& frame);

}  // namespace seiche::render
