#include "solver/sensors/pressure_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "solver/operators/kernels.hpp"

namespace seiche::solver {

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

template LinearPressure<2> fit_pressure(const Vec<2>&, const Vec<2>&, double, const State<2>&, const FluidCells<2>&);
template LinearPressure<3> fit_pressure(const Vec<3>&, const Vec<3>&, double, const State<3>&, const FluidCells<3>&);

}  // namespace seiche::solver
