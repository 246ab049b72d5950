#pragma once
#include <vector>

#include "render/outputs.hpp"
#include "render/picture/axis.hpp"

namespace seiche::render {

/// An axis that holds the values of all curves, on a scale of decades as their logarithms.
Axis chart_axis(const std::vector<Curve>& curves, std::vector<double> Curve::*values, Scale scale);

/// Where a value stands on an axis; not finite where the scale hasn't it.
double place_on(Scale scale, double value);

}  // namespace seiche::render
