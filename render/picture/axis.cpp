#include "render/picture/axis.hpp"

#include <algorithm>

#include "render/picture/overlay.hpp"

namespace seiche::render {

Axis axis_of(Range range, int most) {
  Axis axis{range, {}};
  const Ticks ticks = round_ticks(range, most);
  for (const double value : ticks.values) axis.ticks.push_back({value, tick_label(value, ticks.step)});
  return axis;
}

double label_width(const Axis& axis) {
  double width = 0;
  for (const Tick& tick : axis.ticks) width = std::max(width, text_width(tick.label));
  return width;
}

}  // namespace seiche::render
