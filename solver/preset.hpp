#pragma once
#include "solver/parameters.hpp"

namespace seiche {

/// Replaces everything that a preset governs, by its values, and sets `preset`.
void apply_preset(Parameters& parameters, Preset preset);

}  // namespace seiche
