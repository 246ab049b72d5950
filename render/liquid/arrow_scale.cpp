#include "render/liquid/arrow_scale.hpp"

#include <algorithm>
#include <cmath>

#include "render/picture/range.hpp"
#include "render/picture/ticks.hpp"

namespace seiche::render {

ArrowScale arrow_scale(const RunInfo& run, const Look& look) {
  double greatest = scene_range(run, Quantity::speed).high;
  if (look.quantity == Quantity::speed)
    if (look.range.source == RangeSource::given)
      greatest = std::max(std::abs(look.range.given.low), std::abs(look.range.given.high));
  return {3 * arrow_distance / greatest, greatest, round_below(0.5 * greatest)};
}

double arrow_font(double view_width, double font) {
  constexpr double fewest = 8, smallest = 0.6;
  return std::clamp(view_width / (fewest * arrow_distance), smallest * font, font);
}

}  // namespace seiche::render
