#pragma once
#include <string>

#include "render/look.hpp"
#include "solver/column.hpp"

namespace seiche::render {

/// Root mean square of series less reference, at the reference's times up to a time, the series between its samples by
/// straight lines; not a number where they have no time in common.
double deviation(const Series& series, const Series& reference, double until);

/// As in "4.1 mm RMS off VOF"; `deviation` in the column's unit. Empty where it isn't a number.
std::string deviation_text(double deviation, const Column& column, const std::string& label);

}  // namespace seiche::render
