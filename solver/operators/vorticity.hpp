#pragma once
#include <Eigen/LU>

#include "solver/operators/gradient.hpp"

namespace seiche::solver {

/// Vorticity, the curl of the velocity, at fluid particles [1/s]; zero elsewhere: in 2-D dv/dx - du/dy, in 3-D its
/// magnitude. The velocity's gradient is that of fluid neighbours alone,
///   (sum_j (u_j - u_i) r_ij^T w/r_ij^2) (sum_j r_ij r_ij^T w/r_ij^2)^-1,
/// exact on linear fields (gradient.hpp), also at walls and at the free surface. Where few neighbours make it singular,
/// d/n0 stands for the inverse.
template <int D>
Scalars vorticity(const Pairs<D>& pairs, double n0, const State<D>& s) {
  using Matrix = Eigen::Matrix<double, D, D>;
  const int size = static_cast<int>(s.size());
  Scalars out(size, 0);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    if (s.kind[i] != Kind::fluid) continue;
    OuterSum<D> differences, moments;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      if (s.kind[j] != Kind::fluid) return;
      differences.add(weight * (s.velocity[j] - s.velocity[i]), rij);
      moments.add(weight * rij, rij);
    });
    const Matrix m = D / n0 * moments.matrix(), plain = D / n0 * differences.matrix();
    const Matrix gradient = m.determinant() > least_moment ? Matrix(plain * m.inverse()) : plain;
    const Matrix curl = gradient - gradient.transpose();
    if constexpr (D == 2)
      out[i] = curl(1, 0);
    else
      out[i] = Vec<D>(curl(2, 1), curl(0, 2), curl(1, 0)).norm();
  }
  return out;
}

}  // namespace seiche::solver
