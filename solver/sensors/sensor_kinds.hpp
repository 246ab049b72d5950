#pragma once
#include <vector>

#include "solver/sensors/sensor.hpp"

namespace seiche::solver {

/// All kinds of sensors, in the order of their columns.
template <int D>
const std::vector<SensorKind<D>>& sensor_kinds();

/// The columns of a run's readings: those of its sensors, then of the tank's motion.
std::vector<Column> columns_of(const Parameters& p);

}  // namespace seiche::solver
