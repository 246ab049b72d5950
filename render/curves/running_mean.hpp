#pragma once
#include "render/look.hpp"

namespace seiche::render {

/// At each of the series' times the mean of its finite values within half a window to both sides [s]; not a number
/// where there are none.
Series running_mean(const Series& series, double window);

}  // namespace seiche::render
