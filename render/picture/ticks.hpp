#pragma once
#include <string>
#include <vector>

#include "render/look.hpp"

namespace seiche::render {

/// Values 0, +-step, +-2 step .. within a range, with step = 1, 2, 2.5 or 5 times a power of ten.
struct Ticks {
  std::vector<double> values;
  double step = 1;
};

/// Into how many parts ticks may cut a range.
constexpr int fewest_ticks = 2, most_ticks = 8;

/// `most`: parts that the range is cut into at most.
Ticks round_ticks(Range range, int most = most_ticks);

/// The tick's number without needless digits, as in "500" or "0.25", with a true minus sign.
std::string tick_label(double value, double step);

/// The smallest range between two round ticks that holds `range`; one of no width becomes [low, low + 1] first.
Range rounded(Range range);

/// 1, 2 or 5 times a power of ten, the greatest that isn't above `length`.
double round_below(double length);

}  // namespace seiche::render
