#pragma once
#include <vector>

#include "render/curves/sensor_curve.hpp"
#include "render/look.hpp"
#include "render/panels/variant.hpp"

namespace seiche::render {

/// The plots that `look` asks for, each with a curve of every variant, still without readings. "auto" leaves out the
/// tank's motion; a variant without a sensor of the first one's has no curve of it. Throws std::invalid_argument.
std::vector<SensorCurve> compared_curves(const std::vector<Variant>& variants, const Look& look);

/// To be called once all readings are there. Pressures become their running means, since noise of several runs would
/// hide them all; titles say so. Then axes are fixed: each holds what its references span, and all but a hundredth of
/// the readings of runs that did not fail; of all runs, where each did.
void settle(std::vector<SensorCurve>& curves);

}  // namespace seiche::render
