#pragma once
#include <array>
#include <vector>

#include "render/look.hpp"

namespace seiche::render {

using Point = std::array<double, 2>;
using Line = std::vector<Point>;

/// Times are multiples of an interval, but for rounding.
constexpr double time_slack = 1e-9;

/// The series from time 0 to `until` as lines of (time, value), broken where values aren't finite. Of all points within
/// one `column` of time only the least and the greatest stay, which look the same when a column is a pixel wide; the
/// ends of each line stay as they are.
std::vector<Line> thinned(const Series& series, double until, double column);

/// What of a line lies between two heights, as lines.
std::vector<Line> clipped(const Line& line, Range heights);

/// A line cut into dashes of length `dash` with gaps of length `gap`.
std::vector<Line> dashed(const Line& line, double dash, double gap);

}  // namespace seiche::render
