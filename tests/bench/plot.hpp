#pragma once
#include <filesystem>
#include <vector>

#include "tests/bench/steps.hpp"

namespace seiche::bench {

/// Draws the times of a step by stage over the number of particles, one chart for each number of threads; then the
/// iterations and the memory. Throws render::NoGl.
void plot(const std::filesystem::path& file, const std::vector<StepCost>& costs);

}  // namespace seiche::bench
