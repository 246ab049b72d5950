#pragma once
#include "solver/sensors/fluid_cells.hpp"

namespace seiche::solver {

/// Pressure about a point: value + slope.(r - point).
template <int D>
struct LinearPressure {
  double value = 0;               ///< [Pa]
  Vec<D> slope = Vec<D>::Zero();  ///< [Pa/m]
};

/// How far before a wall that is seen from which looks along it [l0].
constexpr double eye_distance = 1e-3;

/// The linear function that fits the pressure of the fluid within 3 l0 of the point best (weighted least squares, KF3).
/// Exact on a hydrostatic field wherever the neighbours span space; their weighted mean where they don't; 0 where there
/// is no fluid. Fluid that baffles hide doesn't count.
/// @param eye where it is seen from: the point, of a wall just before it
template <int D>
LinearPressure<D> fit_pressure(const Vec<D>& point, const Vec<D>& eye, double l0, const State<D>& s,
                               const FluidCells<D>& cells);

}  // namespace seiche::solver
