#pragma once
#include <optional>
#include <string>

#include "render/look.hpp"
#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// scene, frame, run or "min,max". Throws std::invalid_argument on anything else.
RangeChoice parse_range(const std::string& text);

/// As parse_range() reads it.
std::string text_of(const RangeChoice& range);

/// Known before the first step, and the same for all runs of one scene: QuantityRow::usual, rounded; of classes from
/// the first to the last.
Range scene_range(const RunInfo& run, Quantity quantity = Quantity::pressure);

/// What the look asks for, where it is known before the first frame: "scene", "min,max", or the range of classes.
std::optional<Range> fixed_range(const RunInfo& run, const Look& look);

/// Least and greatest value of the fluid particles; [0, 0] when there are none.
Range fluid_range(const Frame& frame, Quantity quantity = Quantity::pressure);

}  // namespace seiche::render
