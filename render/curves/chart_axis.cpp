#include "render/curves/chart_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/picture/ticks.hpp"

namespace seiche::render {
namespace {

// Finite positions only.
template <class F>
void each_place(const std::vector<Curve>& curves, std::vector<double> Curve::*values, Scale scale, F f) {
  for (const Curve& curve : curves)
    for (const double value : curve.*values)
      if (const double place = place_on(scale, value); std::isfinite(place)) f(place);
}

// From one of 1, 2 and 5 times powers of ten to another, with all between them marked.
Axis decades(Range range) {
  const double high = std::pow(10, range.high);
  double value = round_below(std::pow(10, range.low) * (1 + 1e-9));
  Axis axis;
  for (bool last = false; !last; value = round_below(2.6 * value)) {
    last = !axis.ticks.empty() && value >= high * (1 - 1e-9);
    axis.ticks.push_back({std::log10(value), tick_label(value, round_below(value * (1 + 1e-9)))});
  }
  axis.range = {axis.ticks.front().position, axis.ticks.back().position};
  return axis;
}

}  // namespace

double place_on(Scale scale, double value) {
  if (scale == Scale::linear) return value;
  return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

Axis chart_axis(const std::vector<Curve>& curves, std::vector<double> Curve::*values, Scale scale) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range = scale == Scale::linear ? Range{0, 0} : Range{infinity, -infinity};
  each_place(curves, values, scale, [&](double place) {
    range = {std::min(range.low, place), std::max(range.high, place)};
  });
  if (scale == Scale::linear) return axis_of(rounded(range));
  return decades(range.low <= range.high ? range : Range{0, 1});
}

}  // namespace seiche::render
