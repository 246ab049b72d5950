#pragma once
#include <string>
#include <vector>

#include "render/look.hpp"
#include "render/outputs.hpp"

namespace seiche::render {

/// An axis of a chart: where it begins and ends, and the numbers along it.
struct ChartAxis {
  Range range;
  std::vector<double> places;
  std::vector<std::string> labels;
};

/// Holds the values of all curves, on a scale of decades as their logarithms.
ChartAxis chart_axis(const std::vector<Curve>& curves, std::vector<double> Curve::*values, Scale scale);

/// Where a value stands on an axis; not finite where the scale hasn't it.
double place_on(Scale scale, double value);

}  // namespace seiche::render
