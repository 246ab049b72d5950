#pragma once
#include <optional>
#include <string>

#include "render/look.hpp"
#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// "min,max" as a range; nothing for the named modes. Throws std::invalid_argument on anything else.
std::optional<Range> parse_range(const std::string& text);

/// Known before the first step, and the same for all runs of one scene. Pressure: [0, 1.5 rho g H], rounded. Speed:
/// [0, 0.5 sqrt(g H)], rounded: half of what a long wave travels at, which only waves that break go beyond. Number
/// density: [0.8, 1.2], its ideal in the middle, for diverging colours. Classes: from the first to the last.
Range scene_range(const RunInfo& run, Quantity quantity = Quantity::pressure);

/// What the look asks for, where it is known before the first frame: "scene", "min,max", or the range of classes.
std::optional<Range> fixed_range(const RunInfo& run, const Look& look);

/// Least and greatest value of the fluid particles; [0, 0] when there are none.
Range fluid_range(const Frame& frame, Quantity quantity = Quantity::pressure);

}  // namespace seiche::render
