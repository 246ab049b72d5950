#pragma once
#include <optional>
#include <string>
#include <vector>

#include "render/look.hpp"
#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// Values 0, +-step, +-2 step .. within a range, with step = 1, 2, 2.5 or 5 times a power of ten.
struct Ticks {
  std::vector<double> values;
  double step = 1;
};
/// `most`: parts that the range is cut into at most, 2 or more.
Ticks round_ticks(Range range, int most);

/// Into at most eight parts.
Ticks round_ticks(Range range);

/// The tick's number without needless digits, as in "500" or "0.25", with a true minus sign.
std::string tick_label(double value, double step);

/// The smallest range between two round ticks that holds `range`; one of no width becomes [low, low + 1] first.
Range rounded(Range range);

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

/// 1, 2 or 5 times a power of ten, the greatest that isn't above `length`.
double round_below(double length);

}  // namespace seiche::render
