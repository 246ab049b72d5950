#pragma once
#include <string>
#include <vector>

#include "render/look.hpp"
#include "render/picture/ticks.hpp"

namespace seiche::render {

/// A number along an axis.
struct Tick {
  double position;
  std::string label;
};

/// An axis: where it begins and ends, and the numbers along it.
struct Axis {
  Range range;
  std::vector<Tick> ticks;

  /// How far along it a position is, from 0 where it begins to 1 where it ends.
  double along(double position) const { return (position - range.low) / (range.high - range.low); }
};

/// With round ticks that cut the range into `most` parts at most.
Axis axis_of(Range range, int most = most_ticks);

/// Width of the widest label, in font heights.
double label_width(const Axis& axis);

}  // namespace seiche::render
