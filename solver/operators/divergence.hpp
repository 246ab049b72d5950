#pragma once
#include <Eigen/LU>

#include "solver/operators/gradient.hpp"
#include "solver/operators/rise_across.hpp"

namespace seiche::solver {

/// Gradients of the velocity, the derivative along axis b of component a in row a and column b [1/s].
template <int D>
using VelocityGradients = std::vector<Eigen::Matrix<double, D, D>>;

/// Divergence of the velocity at fluid and wall particles [1/s], and its gradient by the liquid around fluid particles,
/// exact on linear fields of any cloud, 0 where few neighbours make it singular:
///   (sum_j (u_j - u_i) r_ij^T w/r_ij^2) (sum_j r_ij r_ij^T w/r_ij^2)^-1.
///
/// Where no wall is near the divergence is the trace of that, for the reason for which the pressure's gradient is
/// corrected (gradient.hpp).
///
/// Beside a wall, and where few neighbours make that singular: (d/n0) sum_j (u_j - u_i).r_ij w/r_ij^2 (Khayyer & Gotoh
/// 2009, Tanaka & Masunaga 2010). Walls stand still. Behind one the fluid's velocity along the normal goes on mirrored,
/// u_j.n = -u_i.n, so that over the layers beside a wall the sum is the flow that the wall stops, all of it; along the
/// wall nothing counts, so that fluid may slide. Walls count as far as they are wet.
template <int D>
void velocity_divergence(const Pairs<D>& pairs, double n0, const State<D>& s, Scalars& out,
                         VelocityGradients<D>& gradient) {
  using Matrix = Eigen::Matrix<double, D, D>;
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    const bool fluid = s.kind[i] == Kind::fluid;
    bool walled = !fluid;
    const Vec<D> ui = s.velocity[i];
    double sum = 0;
    OuterSum<D> gradients, moments;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      const bool fluid_j = s.kind[j] == Kind::fluid;
      const Vec<D> du = s.velocity[j] - ui;
      if (fluid && fluid_j) {
        sum += weight * du.dot(rij);
        gradients.add(weight * du, rij);
        moments.add(weight * rij, rij);
      } else if ((fluid || fluid_j) && s.wet[j] != 0) {
        walled = true;
        const Vec<D> normal = fluid ? s.normal_from(s.position[i], j) : s.normal_from(s.position[j], i);
        sum += (fluid ? s.wet[j] : 1) * weight * 2 * rise_across(normal, du, rij);
      }
    });
    const Matrix moment = moments.matrix();
    const bool singular = !((D / n0 * moment).determinant() > least_moment);
    gradient[i] = singular ? Matrix(Matrix::Zero()) : Matrix(gradients.matrix() * moment.inverse());
    out[i] = walled || singular ? D / n0 * sum : gradient[i].trace();
  }
}

}  // namespace seiche::solver
