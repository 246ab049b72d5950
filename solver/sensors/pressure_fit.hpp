#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "solver/operators/kernels.hpp"
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
                               const FluidCells<D>& cells) {
  const KF3 w{FluidCells<D>::reach * l0};
  using Row = Eigen::Matrix<double, D + 1, 1>;
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Row right = Row::Zero();
  cells.near(point, [&](int j, const Vec<D>& offset) {
    if (s.baffles && !s.baffles->sees(eye, s.position[j])) return;
    const double weight = w(offset.norm());
    Row row;
    row << 1, offset / l0;
    normal += weight * row * row.transpose();
    right += weight * s.pressure[j] * row;
  });
  if (normal(0, 0) == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D + 1, D + 1>> spectrum(normal);
  // 1e-3 of the greatest: below it the neighbours lie nearly in a line (plane) and a slope would be noise.
  if (spectrum.eigenvalues()[0] < 1e-3 * spectrum.eigenvalues()[D]) return {right[0] / normal(0, 0)};
  const Row fit = normal.ldlt().solve(right);
  return {fit[0], fit.template tail<D>() / l0};
}

}  // namespace seiche::solver
